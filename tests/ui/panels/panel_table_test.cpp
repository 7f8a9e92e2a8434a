#include "ui/panels/panel_table.h"

#include <doctest/doctest.h>

#include <string>

TEST_CASE("each panel has one row, and each panel of the bottom pane a tab") {
    CHECK(panels().size() == panel_kinds.size());
    for (const PanelKind& kind : panel_kinds) {
        const Panel& panel = panel_of(kind.id);
        CAPTURE(panel.title);
        CHECK(panel.id == kind.id);
        CHECK((std::string(panel.tab) != "") == (kind.place == PanelPlace::bottom));
    }
}

TEST_CASE("toggling a panel shows and hides it, also from full screen if it leaves that") {
    WindowState window;
    toggle(panel_of(PanelId::library), window);
    CHECK_FALSE(window.layout.panels.is_open(PanelId::library));
    window.layout.is_picture_only = true;
    toggle(panel_of(PanelId::strip), window);
    CHECK_FALSE(window.layout.panels.is_open(PanelId::strip));
    CHECK(window.layout.is_picture_only);
    toggle(panel_of(PanelId::presets), window);
    CHECK(window.layout.sees(PanelId::presets));
    CHECK(window.layout.sizes.bottom == 250.0f);
    window.layout.is_picture_only = true;
    toggle(panel_of(PanelId::presets), window);
    CHECK(window.layout.sees(PanelId::presets));
    toggle(panel_of(PanelId::presets), window);
    CHECK_FALSE(window.layout.panels.is_open(PanelId::presets));
}
