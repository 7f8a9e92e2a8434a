#include "lab/window/open_panels.h"

#include <algorithm>

namespace {
const PanelKind& kind_of(PanelId panel) {
    return *std::ranges::find(panel_kinds, panel, &PanelKind::id);
}
}  // namespace

PanelPlace place_of(PanelId panel) {
    return kind_of(panel).place;
}

OpenPanels::OpenPanels() {
    for (const PanelKind& kind : panel_kinds)
        if (kind.is_open)
            m_open.insert(kind.id);
}

std::optional<PanelId> OpenPanels::shown_in(PanelPlace place) const {
    std::optional<PanelId> shown;
    for (const PanelKind& kind : panel_kinds)
        if (kind.place == place && is_open(kind.id))
            shown = kind.id;
    return shown;
}

void OpenPanels::show(PanelId panel) {
    const PanelKind& shown = kind_of(panel);
    if (!shown.covers)
        for (const PanelKind& kind : panel_kinds)
            if (kind.place == shown.place)
                hide(kind.id);
    m_open.insert(panel);
}
