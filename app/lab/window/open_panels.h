#pragma once

#include <optional>
#include <set>
#include <string_view>
#include <vector>

/// The name of a panel of the window, and its key in the session. Valid while the program runs.
using PanelId = std::string_view;

/// Panels that other code shows or asks for. Each panel is a row of ui/panels/panel_table.cpp.
namespace panel_id {
inline constexpr PanelId library = "library";
inline constexpr PanelId history = "history";
inline constexpr PanelId parameters = "parameters";
inline constexpr PanelId inspector = "inspector";
inline constexpr PanelId strip = "strip";
inline constexpr PanelId problems = "problems";
inline constexpr PanelId timings = "timings";
inline constexpr PanelId pins = "pins";
inline constexpr PanelId sheet = "sheet";
inline constexpr PanelId waveform = "waveform";
inline constexpr PanelId presets = "presets";
inline constexpr PanelId remote = "remote";
inline constexpr PanelId timeline = "timeline";
inline constexpr PanelId playlist = "playlist";
}  // namespace panel_id

/// An area of the window for panels, of which it shows one.
enum class PanelPlace { left, right, lower_right, strip, bottom };

/// The place of a panel.
struct PanelKind {
    PanelId id;
    PanelPlace place = PanelPlace::bottom;
    bool is_open = false;  // at the first start
    bool covers = false;   // the panel below it stays open

    bool operator==(const PanelKind&) const = default;
};

/// The panels that are open. A place shows the last of its open ones, in the order of the kinds. A
/// panel that is not among them is alone in its place.
class OpenPanels {
public:
    OpenPanels() = default;
    explicit OpenPanels(std::vector<PanelKind> kinds);
    bool operator==(const OpenPanels&) const = default;

    const std::vector<PanelKind>& kinds() const { return m_kinds; }
    bool shows(PanelId panel) const;
    std::optional<PanelId> shown_in(PanelPlace place) const;
    /// Also while another panel covers it.
    bool is_open(PanelId panel) const { return m_open.contains(panel); }

    void show(PanelId panel);
    void hide(PanelId panel) { m_open.erase(panel); }

private:
    const PanelKind* kind_of(PanelId panel) const;

    std::vector<PanelKind> m_kinds;
    std::set<PanelId> m_open;
};
