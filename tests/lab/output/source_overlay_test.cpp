#include "lab/output/source_overlay.h"

#include "io/system/environment.h"
#include "lab/document/content_edits.h"
#include "lab/export/export_target.h"
#include "lab/window/window_state.h"

#include <doctest/doctest.h>

namespace {
Document showing(const std::string& source) {
    Look look;
    look.driven_by = Driver::picture;
    look.default_source = "pattern:white";
    Document document(look);
    set_source(document, source);
    return document;
}
}  // namespace

TEST_CASE("an overlay covers the window that the source shows") {
    const Document game = showing("window:Game, level 1");
    const Document cropped = showing("window:Game,fit=crop");
    const Document screen = showing("screen:");
    const Document picture = showing("picture.png");
    CHECK(overlaid_window(&game) == "Game, level 1");
    CHECK(overlaid_window(&cropped) == "Game");
    CHECK(overlaid_window(&screen).empty());
    CHECK(overlaid_window(&picture).empty());
    CHECK(overlaid_window(nullptr).empty());
}

TEST_CASE("an overlay without a window as the source is refused") {
    unset_environment("WAYLAND_DISPLAY");
    const Document game = showing("window:Game");
    const Document screen = showing("screen:");
    CHECK_FALSE(overlay_refusal(&game));
    const auto refusal = overlay_refusal(&screen);
    REQUIRE(refusal);
    CHECK(refusal->text.starts_with("The overlay needs a window as its source."));
    CHECK(refusal->buttons.empty());
}

TEST_CASE("on Wayland an overlay is refused, and exports are offered") {
    set_environment("WAYLAND_DISPLAY", "wayland-0");
    const Document game = showing("window:Game");
    const auto refusal = overlay_refusal(&game);
    unset_environment("WAYLAND_DISPLAY");
    REQUIRE(refusal);
    CHECK(refusal->text.starts_with("A Wayland desktop does not let a program"));
    REQUIRE(refusal->buttons.size() == 2);
    WindowState window;
    MutableParts parts{};
    std::get<WindowState*>(parts) = &window;
    for (const MenuEntry& button : refusal->buttons) {
        button.commands.front()(parts);
        CHECK(window.dialog.kind == Dialog::Kind::export_look);
        const std::string& target = export_targets()[window.look_export.target].name;
        CHECK(button.name == (target == "reshade" ? "Export for ReShade…" : "Export for mpv…"));
        CHECK((target == "reshade" || target == "mpv"));
    }
}
