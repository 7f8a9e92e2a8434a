#include "lab/window/open_panels.h"

#include <doctest/doctest.h>

namespace {
OpenPanels some_panels() {
    return OpenPanels({{panel_id::library, PanelPlace::left, true},
                       {panel_id::history, PanelPlace::left, false, true},
                       {panel_id::strip, PanelPlace::strip, true},
                       {panel_id::pins, PanelPlace::bottom},
                       {panel_id::presets, PanelPlace::bottom}});
}
}  // namespace

TEST_CASE("a place shows one panel") {
    OpenPanels panels = some_panels();
    CHECK_FALSE(panels.shown_in(PanelPlace::bottom).has_value());
    panels.show(panel_id::presets);
    panels.show(panel_id::pins);
    CHECK(panels.shown_in(PanelPlace::bottom) == panel_id::pins);
    CHECK_FALSE(panels.is_open(panel_id::presets));
    CHECK(panels.shows(panel_id::strip));
    panels.hide(panel_id::pins);
    CHECK_FALSE(panels.shown_in(PanelPlace::bottom).has_value());
}

TEST_CASE("the history covers the looks until it is closed or the looks are shown") {
    OpenPanels panels = some_panels();
    panels.show(panel_id::history);
    CHECK(panels.shown_in(PanelPlace::left) == panel_id::history);
    CHECK_FALSE(panels.shows(panel_id::library));
    CHECK(panels.is_open(panel_id::library));
    panels.hide(panel_id::history);
    CHECK(panels.shows(panel_id::library));
    panels.show(panel_id::history);
    panels.show(panel_id::library);
    CHECK(panels.shows(panel_id::library));
    CHECK_FALSE(panels.is_open(panel_id::history));
}

TEST_CASE("a panel without a kind is alone in its place") {
    OpenPanels panels;
    CHECK_FALSE(panels.shows(panel_id::pins));
    panels.show(panel_id::pins);
    panels.show(panel_id::presets);
    CHECK(panels.shows(panel_id::pins));
    panels.hide(panel_id::pins);
    CHECK_FALSE(panels.shows(panel_id::pins));
}
