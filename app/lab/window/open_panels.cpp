#include "lab/window/open_panels.h"

#include <algorithm>

OpenPanels::OpenPanels(std::vector<PanelKind> kinds) : m_kinds(std::move(kinds)) {
    for (const PanelKind& kind : m_kinds)
        if (kind.is_open)
            m_open.insert(kind.id);
}

const PanelKind* OpenPanels::kind_of(PanelId panel) const {
    const auto found = std::ranges::find(m_kinds, panel, &PanelKind::id);
    return found == m_kinds.end() ? nullptr : &*found;
}

bool OpenPanels::shows(PanelId panel) const {
    const PanelKind* const kind = kind_of(panel);
    return kind ? shown_in(kind->place) == panel : is_open(panel);
}

std::optional<PanelId> OpenPanels::shown_in(PanelPlace place) const {
    std::optional<PanelId> shown;
    for (const PanelKind& kind : m_kinds)
        if (kind.place == place && is_open(kind.id))
            shown = kind.id;
    return shown;
}

void OpenPanels::show(PanelId panel) {
    const PanelKind* const shown = kind_of(panel);
    if (shown && !shown->covers)
        for (const PanelKind& kind : m_kinds)
            if (kind.place == shown->place)
                hide(kind.id);
    m_open.insert(panel);
}
