#include "lab/window/window_session.h"

#include <doctest/doctest.h>

namespace {
std::vector<PanelKind> some_panels() {
    return {{panel_id::library, PanelPlace::left, true},
            {panel_id::history, PanelPlace::left, false, true},
            {panel_id::strip, PanelPlace::strip, true},
            {panel_id::problems, PanelPlace::bottom},
            {panel_id::timings, PanelPlace::bottom},
            {panel_id::presets, PanelPlace::bottom}};
}

WindowState restored(const std::map<std::string, double>& numbers) {
    return restored_window(numbers, some_panels());
}
}  // namespace

TEST_CASE("recent palette entries and recent files are restored in order") {
    WindowState window;
    window.recent.commands = {"Undo", "preset:/a: b.json", "Open…"};
    CHECK(restored_window(serialized_window(window)).recent.commands == window.recent.commands);
    CHECK(restored_window({}).recent.commands.empty());
    window.recent.files = {"/songs/ä b.wav", "/a.json"};
    CHECK(restored_window(serialized_window(window)).recent.files == window.recent.files);
    CHECK(restored_window(serialized_window(window)).recent.commands == window.recent.commands);
}

TEST_CASE("typed addresses of running programs are restored") {
    WindowState window;
    window.sending.addresses = {{"RetroArch", "55356"}, {"mpv", "/tmp/a:b"}, {"other", ""}};
    const auto again = restored(serialized_window(window)).sending.addresses;
    CHECK(again == std::map<std::string, std::string>{{"RetroArch", "55356"}, {"mpv", "/tmp/a:b"}});
    CHECK(restored({{"send:mpv", 0.0}, {"send:mpv:", 0.0}}).sending.addresses.empty());
}

TEST_CASE("file dialogs are restored with the last folder of each kind") {
    WindowState window;
    window.file_dialogs = {.folders = {{"open", "/songs/ä: b"}, {"video", "/films"}},
                           .order = {FileOrder::Key::modified, true},
                           .shows_hidden = true,
                           .uses_desktop = false};
    const FileDialogChoices again = restored(serialized_window(window)).file_dialogs;
    CHECK(again.folders == window.file_dialogs.folders);
    CHECK(again.order == window.file_dialogs.order);
    CHECK(again.shows_hidden);
    CHECK_FALSE(again.uses_desktop);
    CHECK(restored({}).file_dialogs.uses_desktop);
    CHECK(restored({{"file_order", 7.0}, {"folder:open:relative", 0.0}, {"folder:x", 0.0}})
              .file_dialogs.folders.empty());
}

TEST_CASE("the wipe position is restored if it is within the picture") {
    WindowState window;
    window.views.wipe_share = 0.25;
    CHECK(restored_window(serialized_window(window)).views.wipe_share == 0.25);
    CHECK(restored_window({{"wipe_share", 7.0}}).views.wipe_share == 0.5);
}

TEST_CASE("the open panels are restored") {
    WindowState window = restored({});
    CHECK(restored(serialized_window(window)).layout == window.layout);
    CHECK_FALSE(serialized_window(window).contains("problems"));
    window.layout.panels.show(panel_id::history);
    window.layout.panels.hide(panel_id::strip);
    const auto numbers = serialized_window(window);
    CHECK(numbers.at("library") == 1.0);  // covered
    CHECK(numbers.at("history") == 1.0);
    CHECK(numbers.at("strip") == 0.0);
    CHECK(numbers.at("bottom") == 0.0);
    CHECK(restored(numbers).layout == window.layout);
    CHECK(restored({{"library", 0.0}, {"history", 1.0}}).layout.panels.shown_in(PanelPlace::left) ==
          panel_id::history);
    CHECK_FALSE(restored({{"library", 0.0}}).layout.panels.is_open(panel_id::library));
}

TEST_CASE("the panel in the bottom pane is restored") {
    WindowState window = restored({});
    window.layout.panels.show(panel_id::presets);
    CHECK(restored(serialized_window(window)).layout == window.layout);
    window.frame_rate.budget_milliseconds = 8.0;
    CHECK(restored(serialized_window(window)).frame_rate.budget_milliseconds == 8.0);
    const auto bottom = [](double number) {
        const std::map<std::string, double> numbers{{"bottom", 1.0}, {"bottom_part", number}};
        return restored(numbers).layout.panels.shown_in(PanelPlace::bottom);
    };
    CHECK(bottom(1.0) == panel_id::timings);
    CHECK(bottom(2.0) == panel_id::presets);
    CHECK(bottom(3.0) == panel_id::problems);
    CHECK(restored({{"bottom_part", 5.0}}).layout == restored({}).layout);
}

TEST_CASE("pins, the waveform line and the inspector's settings are restored") {
    WindowState window;
    window.probes.pins = {{0.25, 0.75}, {1.0, 0.0}};
    window.probes.scan_line = {{0.1, 0.2}, {0.3, 0.4}};
    window.probes.plots_luminance = true;
    window.views.inspected.levels = {-0.5, 12.0};
    window.views.inspected.exposure = -3.5;
    window.views.inspected.channels = Channels::luminance;
    const WindowState back = restored_window(serialized_window(window));
    CHECK(back.probes.pins == window.probes.pins);
    CHECK(back.probes.scan_line == window.probes.scan_line);
    CHECK(back.probes.plots_luminance);
    CHECK(back.views.inspected == window.views.inspected);
}

TEST_CASE("invalid session values become defaults") {
    const WindowState back = restored_window({{"black", 2.0},
                                              {"white", 1.0},
                                              {"exposure", 1e6},
                                              {"channels", 77.0},
                                              {"pin1_x", 0.5},
                                              {"pin2_x", 0.5},
                                              {"pin2_y", 1.5},
                                              {"line_start_x", 0.5}});
    CHECK(back.views.inspected == PassView{});
    CHECK(back.probes.pins.empty());
    CHECK(back.probes.scan_line == ScanLine{});
}

TEST_CASE("the frame rate setting is restored") {
    WindowState window;
    window.frame_rate = {false, 60.0};
    CHECK(restored_window(serialized_window(window)).frame_rate == window.frame_rate);
    CHECK(restored_window({{"frame_cap", -3.0}, {"vsync", 7.0}}).frame_rate == FrameRate{});
    CHECK(FrameRate{}.frame_seconds(144.0) == 1.0 / 144.0);
    CHECK(FrameRate{.cap = 30.0}.frame_seconds(144.0) == 1.0 / 30.0);
    CHECK(FrameRate{}.frame_seconds(0.0) == 1.0 / 24.0);  // a display without a reported rate
}

TEST_CASE("the output window prefers a display without the panels") {
    CHECK(OutputState{}.monitor_for(1, 0) == 0);
    CHECK(OutputState{}.monitor_for(2, 0) == 1);
    CHECK(OutputState{}.monitor_for(2, 1) == 0);
    CHECK(OutputState{.monitor = 1}.monitor_for(2, 1) == 1);  // the user's choice
    CHECK(OutputState{.monitor = 2}.monitor_for(2, 0) == 1);  // this display is gone
    WindowState window;
    window.output = {.is_open = true, .monitor = 3};
    const OutputState restored = restored_window(serialized_window(window)).output;
    CHECK(restored.monitor == 3);
    CHECK_FALSE(restored.is_open);
}

TEST_CASE("the flash limiter is restored, and a rate beyond the limits becomes the default") {
    WindowState window;
    CHECK_FALSE(restored_window(serialized_window(window)).flashes.limit.is_on);
    window.flashes.limit = {true, 0.45};
    CHECK(restored_window(serialized_window(window)).flashes.limit == FlashLimit{true, 0.45});
    window.flashes.limit.max_per_second = 5.0;
    CHECK(restored_window(serialized_window(window)).flashes.limit == FlashLimit{true, 0.3});
}
