#include "lab/window/window_state.h"

#include "lab/lab.h"
#include "lab/window/window_session.h"

#include <doctest/doctest.h>

TEST_CASE("a picture is shown at a whole-number zoom, or completely if larger than its view") {
    const PictureView view;
    CHECK(view.zoom_for({480, 270}, {1000, 600}) == 2.0);
    CHECK(view.zoom_for({480, 270}, {480, 270}) == 1.0);
    CHECK(view.zoom_for({480, 270}, {500, 300}) == 1.0);
    CHECK(view.zoom_for({480, 270}, {300, 400}) == 300.0 / 480.0);
    CHECK(view.zoom_for({2000, 1000}, {1000, 500}) == 0.5);  // twice the view's size
    const PicturePosition place = position_of(view, {480, 270}, {240, 400});
    CHECK(place.left == 0.0);
    CHECK(place.top == (400 - 135) / 2.0 + 0.5);  // on a whole screen pixel
}

TEST_CASE("zooming keeps the point under the pointer in place") {
    const Extent picture{400, 200};
    const Extent room{200, 100};
    PictureView view{PictureView::Fit::free, 2.0, 0.5, 0.5};
    const std::array<double, 2> pointer{50.0, 25.0};
    const auto before = position_of(view, picture, room).pixel_at(pointer[0], pointer[1]);
    view.zoom_about(before[0] / picture.width, before[1] / picture.height, 2.0, 4.0);
    const auto after = position_of(view, picture, room).pixel_at(pointer[0], pointer[1]);
    CHECK(std::abs(after[0] - before[0]) <= 0.5 / 4.0);  // places are whole screen pixels
    CHECK(std::abs(after[1] - before[1]) <= 0.5 / 4.0);
    CHECK(view.zoom == 4.0);
}

TEST_CASE("the render size follows the view or is fixed, and both can be scaled") {
    CHECK(PictureSize{}.room({801, 600}) == Extent{801, 600});
    CHECK(PictureSize{true, {320, 240}}.room({801, 600}) == Extent{801, 600});
    CHECK(PictureSize{false, {320, 240}}.room({801, 600}) == Extent{320, 240});
    CHECK(PictureSize{true, {}, 0.25}.scaled({801, 600}) == Extent{200, 150});
    CHECK(PictureSize{true, {}, 0.25}.scaled({1, 1}) == Extent{1, 1});
    CHECK(PictureSize{false, {320, 240}, 2.0}.scaled({320, 240}) == Extent{640, 480});
}

TEST_CASE("a new render size is to be chosen, and a chosen one does not follow the view") {
    CHECK(PictureSize{}.is_to_be_chosen());
    const PictureSize chosen = fixed_in(PictureSize{true, {}, 0.5}, {801, 600});
    CHECK_FALSE(chosen.is_to_be_chosen());
    CHECK_FALSE(chosen.follows_view);
    CHECK(chosen.has_shape());  // a look from another program keeps its source's shape in it
    CHECK(chosen.room({100, 100}) == Extent{801, 600});
    CHECK(chosen.scaled(chosen.room({100, 100})) == Extent{401, 300});
    const PictureSize exact{false, {320, 240}};
    CHECK_FALSE(exact.has_shape());
}

TEST_CASE("recent palette entries and recent files are restored in order") {
    WindowState window;
    window.used = {"Undo", "preset:/a: b.json", "Open…"};
    CHECK(restored_window(remembered(window)).used == window.used);
    CHECK(restored_window({}).used.empty());
    window.recent_files = {"/songs/ä b.wav", "/a.json"};
    CHECK(restored_window(remembered(window)).recent_files == window.recent_files);
    CHECK(restored_window(remembered(window)).used == window.used);
}

TEST_CASE("the wipe position is restored if it is within the picture") {
    WindowState window;
    window.wipe_share = 0.25;
    CHECK(restored_window(remembered(window)).wipe_share == 0.25);
    CHECK(restored_window({{"wipe_share", 7.0}}).wipe_share == 0.5);
}

TEST_CASE("fitting shows every value of a pass, and resetting restores the defaults") {
    PassView view;
    view.exposure = 3.0;
    view.channels = Channels::green;
    view.fit({.minimum = -1.0, .maximum = 7.0, .finite = 2});
    CHECK(view.levels == Levels{-1, 7});
    CHECK(view.exposure == 0.0);
    CHECK(view.has_levels());
    view.reset_levels();
    CHECK_FALSE(view.has_levels());
    CHECK(view.channels == Channels::green);
}

TEST_CASE("a pinned pixel is the same point in targets of every size") {
    const Pin pin = pin_at({"beam", 100, 30, false, {400, 60}});
    CHECK(pin.texel({400, 60}) == std::array{100, 30});
    CHECK(pin.texel({200, 30}) == std::array{50, 15});
    CHECK(pin.texel({1200, 180}) == std::array{301, 91});
    CHECK(pin.texel({1, 1}) == std::array{0, 0});
    CHECK(Pin{1.0, 1.0}.texel({400, 60}) == std::array{399, 59});
}

TEST_CASE("the open panels are restored") {
    WindowState window;
    CHECK(restored_window(remembered(window)).layout == window.layout);
    CHECK_FALSE(remembered(window).contains("problems"));
    window.layout.panels.show(PanelId::history);
    window.layout.panels.hide(PanelId::strip);
    const auto numbers = remembered(window);
    CHECK(numbers.at("library") == 1.0);  // covered
    CHECK(numbers.at("history") == 1.0);
    CHECK(numbers.at("strip") == 0.0);
    CHECK(numbers.at("bottom") == 0.0);
    CHECK(restored_window(numbers).layout == window.layout);
    CHECK(restored_window({{"library", 0.0}, {"history", 1.0}})
              .layout.panels.shown_in(PanelPlace::left) == PanelId::history);
    CHECK_FALSE(restored_window({{"library", 0.0}}).layout.panels.is_open(PanelId::library));
}

TEST_CASE("the panel in the bottom pane is restored") {
    WindowState window;
    window.layout.panels.show(PanelId::graph);
    CHECK(restored_window(remembered(window)).layout == window.layout);
    window.budget_milliseconds = 8.0;
    CHECK(restored_window(remembered(window)).budget_milliseconds == 8.0);
    const auto bottom = [](double number) {
        const std::map<std::string, double> numbers{{"bottom", 1.0}, {"bottom_part", number}};
        return restored_window(numbers).layout.panels.shown_in(PanelPlace::bottom);
    };
    CHECK(bottom(1.0) == PanelId::timings);
    CHECK(bottom(8.0) == PanelId::presets);
    CHECK(bottom(9.0) == PanelId::problems);
    CHECK(restored_window({{"bottom_part", 5.0}}).layout == WindowLayout{});
}

TEST_CASE("pins, the waveform line and the inspector's settings are restored") {
    WindowState window;
    window.pins = {{0.25, 0.75}, {1.0, 0.0}};
    window.scan_line = {{0.1, 0.2}, {0.3, 0.4}};
    window.plots_luminance = true;
    window.inspected.levels = {-0.5, 12.0};
    window.inspected.exposure = -3.5;
    window.inspected.channels = Channels::luminance;
    const WindowState back = restored_window(remembered(window));
    CHECK(back.pins == window.pins);
    CHECK(back.scan_line == window.scan_line);
    CHECK(back.plots_luminance);
    CHECK(back.inspected == window.inspected);
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
    CHECK(back.inspected == PassView{});
    CHECK(back.pins.empty());
    CHECK(back.scan_line == ScanLine{});
}

TEST_CASE("inspecting another pass shows its current picture") {
    PassView view;
    view.look_into({Input::From::pass, "persistence", 1});
    CHECK(view.pass == "persistence");
    CHECK(view.label() == "persistence@1");
    view.look_into({Input::From::image, "noise", 0, 2});
    CHECK(view.pass == "persistence");
    CHECK(view.label() == "noise mip 2");
    view.look_into("beam");
    CHECK(view.label() == "beam");
    view.look_into({Input::From::pass, "glass"});
    CHECK_FALSE(view.other.has_value());
}

TEST_CASE("the frame rate setting is restored") {
    WindowState window;
    window.frame_rate = {false, 60.0};
    CHECK(restored_window(remembered(window)).frame_rate == window.frame_rate);
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
    window.output = {true, false, 3};
    const OutputState restored = restored_window(remembered(window)).output;
    CHECK(restored.monitor == 3);
    CHECK_FALSE(restored.is_open);
}

TEST_CASE("the flash limiter is restored, and a rate beyond the limits becomes the default") {
    WindowState window;
    CHECK_FALSE(restored_window(remembered(window)).comfort.is_on);
    window.comfort = {true, 0.45};
    CHECK(restored_window(remembered(window)).comfort == FlashLimit{true, 0.45});
    window.comfort.most_a_second = 5.0;
    CHECK(restored_window(remembered(window)).comfort == FlashLimit{true, 0.3});
}
