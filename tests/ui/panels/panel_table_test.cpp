#include "ui/panels/panel_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

TEST_CASE("panels have different ids, and each panel of the bottom pane has a tab") {
    std::set<PanelId> ids;
    for (const Panel& panel : panels()) {
        CAPTURE(panel.title);
        CHECK(ids.insert(panel.id).second);
        CHECK(&panel_of(panel.id) == &panel);
        CHECK((std::string(panel.tab) != "") == (panel.place == PanelPlace::bottom));
    }
}

TEST_CASE("every panel id that other code uses has a row") {
    for (const PanelId id :
         {panel_id::library, panel_id::history, panel_id::parameters, panel_id::inspector,
          panel_id::strip, panel_id::problems, panel_id::timings, panel_id::pins, panel_id::sheet,
          panel_id::waveform, panel_id::presets})
        CHECK(std::ranges::count(panels(), id, &Panel::id) == 1);
}

TEST_CASE("the first start shows looks, parameters, inspector and strip") {
    const OpenPanels open(panel_kinds());
    CHECK(open.shown_in(PanelPlace::left) == panel_id::library);
    CHECK(open.shown_in(PanelPlace::right) == panel_id::parameters);
    CHECK(open.shown_in(PanelPlace::lower_right) == panel_id::inspector);
    CHECK(open.shown_in(PanelPlace::strip) == panel_id::strip);
    CHECK_FALSE(open.shown_in(PanelPlace::bottom).has_value());
}

TEST_CASE("toggling a panel shows and hides it, also from full screen if it leaves that") {
    WindowState window;
    window.layout.panels = OpenPanels(panel_kinds());
    toggle(panel_of(panel_id::library), window);
    CHECK_FALSE(window.layout.panels.is_open(panel_id::library));
    window.layout.is_picture_only = true;
    toggle(panel_of(panel_id::strip), window);
    CHECK_FALSE(window.layout.panels.is_open(panel_id::strip));
    CHECK(window.layout.is_picture_only);
    toggle(panel_of(panel_id::presets), window);
    CHECK(window.layout.sees(panel_id::presets));
    CHECK(window.layout.sizes.bottom == 250.0f);
    window.layout.is_picture_only = true;
    toggle(panel_of(panel_id::presets), window);
    CHECK(window.layout.sees(panel_id::presets));
    toggle(panel_of(panel_id::presets), window);
    CHECK_FALSE(window.layout.panels.is_open(panel_id::presets));
}
