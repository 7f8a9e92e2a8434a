#pragma once

#include <array>
#include <optional>
#include <set>

/// A panel of the window. What draws it is in its row of ui/panels/panel_table.cpp.
enum class PanelId {
    library,
    history,
    parameters,
    inspector,
    strip,
    problems,
    timings,
    pins,
    inputs,
    text,
    graph,
    sheet,
    waveform,
    presets,
};

/// An area of the window for panels, of which it shows one.
enum class PanelPlace { left, right, lower_right, strip, bottom };

/// The default place of a panel, and how the session stores it.
struct PanelKind {
    PanelId id;
    PanelPlace place;
    const char* key = nullptr;  // in the session; null: it stores the place's panel by its number
    bool is_open = false;       // at the first start
    bool covers = false;        // the panel below it stays open
};

/// One for each PanelId. The session stores the position of a bottom panel: add new ones last.
inline constexpr std::array panel_kinds{
    PanelKind{PanelId::library, PanelPlace::left, "library", true},
    PanelKind{PanelId::history, PanelPlace::left, "history", false, true},
    PanelKind{PanelId::parameters, PanelPlace::right, "parameters", true},
    PanelKind{PanelId::inspector, PanelPlace::lower_right, "inspector", true},
    PanelKind{PanelId::strip, PanelPlace::strip, "strip", true},
    PanelKind{PanelId::problems, PanelPlace::bottom},
    PanelKind{PanelId::timings, PanelPlace::bottom},
    PanelKind{PanelId::pins, PanelPlace::bottom},
    PanelKind{PanelId::inputs, PanelPlace::bottom},
    PanelKind{PanelId::text, PanelPlace::bottom},
    PanelKind{PanelId::graph, PanelPlace::bottom},
    PanelKind{PanelId::sheet, PanelPlace::bottom},
    PanelKind{PanelId::waveform, PanelPlace::bottom},
    PanelKind{PanelId::presets, PanelPlace::bottom},
};
PanelPlace place_of(PanelId panel);

/// The panels that are open. A place shows the last of its open ones, in the order of panel_kinds.
class OpenPanels {
public:
    OpenPanels();
    bool operator==(const OpenPanels&) const = default;

    bool shows(PanelId panel) const { return shown_in(place_of(panel)) == panel; }
    std::optional<PanelId> shown_in(PanelPlace place) const;
    /// Also while another panel covers it.
    bool is_open(PanelId panel) const { return m_open.contains(panel); }

    void show(PanelId panel);
    void hide(PanelId panel) { m_open.erase(panel); }

private:
    std::set<PanelId> m_open;
};
