#include "lab/window/open_panels.h"

#include <doctest/doctest.h>

#include <string>

TEST_CASE("panel kinds are in the order of their ids, and their session keys differ") {
    std::set<std::string> keys;
    for (std::size_t i = 0; i < panel_kinds.size(); ++i) {
        CAPTURE(i);
        CHECK(static_cast<std::size_t>(panel_kinds[i].id) == i);
        if (panel_kinds[i].key)
            CHECK(keys.insert(panel_kinds[i].key).second);
        CHECK((panel_kinds[i].key == nullptr) == (panel_kinds[i].place == PanelPlace::bottom));
    }
}

TEST_CASE("a place shows one panel") {
    OpenPanels panels;
    CHECK_FALSE(panels.shown_in(PanelPlace::bottom).has_value());
    panels.show(PanelId::presets);
    panels.show(PanelId::pins);
    CHECK(panels.shown_in(PanelPlace::bottom) == PanelId::pins);
    CHECK_FALSE(panels.is_open(PanelId::presets));
    CHECK(panels.shows(PanelId::strip));
    panels.hide(PanelId::pins);
    CHECK_FALSE(panels.shown_in(PanelPlace::bottom).has_value());
}

TEST_CASE("the history covers the looks until it is closed or the looks are shown") {
    OpenPanels panels;
    panels.show(PanelId::history);
    CHECK(panels.shown_in(PanelPlace::left) == PanelId::history);
    CHECK_FALSE(panels.shows(PanelId::library));
    CHECK(panels.is_open(PanelId::library));
    panels.hide(PanelId::history);
    CHECK(panels.shows(PanelId::library));
    panels.show(PanelId::history);
    panels.show(PanelId::library);
    CHECK(panels.shows(PanelId::library));
    CHECK_FALSE(panels.is_open(PanelId::history));
}
