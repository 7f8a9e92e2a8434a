#include "lab/small_lab.h"
#include "lab/views/views.h"

#include <cmath>

namespace {
// Red in the middle of the view, in 8-bit levels; -1 without a picture.
int displayed_value(const Lab& lab, Views& views) {
    WindowState window;
    window.views.sizes.picture = {8, 8};
    window.layout.is_picture_only = true;
    views.update(lab, window);
    const Picture picture = views.main().read_picture();
    return picture.extent.is_empty()
               ? -1
               : static_cast<int>(std::lround(picture.pixels[picture.index(4, 4)] * 255.0f));
}

void pause(SmallLab& small) {
    small.lab().player().pause();
    REQUIRE(small.update_until([&] { return !small.lab().is_moving(); }));
}
}  // namespace

TEST_CASE("a bypassed pass outputs its input, also in a static picture") {
    SmallLab small;
    small.lab().edit([](Document& document) { document.set_value("gain", Value(4.0)); });
    pause(small);
    CHECK(small.shown() == 4 * small.frames());
    small.lab().frames().passes().toggle(PassSwitch::bypass, "show");
    small.update(1);
    CHECK(small.shown() == small.frames());
    CHECK_FALSE(small.lab().is_moving());
    small.lab().frames().passes().toggle(PassSwitch::bypass, "show");
    small.update(1);
    CHECK(small.shown() == 4 * small.frames());
}

TEST_CASE("a bypass without an input is refused with a notice") {
    SmallLab small;
    small.lab().frames().passes().toggle(PassSwitch::bypass, "sum");
    CHECK(small.lab().frames().passes().switches().is_empty());
    REQUIRE(small.lab().messages().notice());
    CHECK(small.lab().messages().notice()->is_problem);
    CHECK(small.lab().messages().notice()->text.find("only its own output") != std::string::npos);
}

TEST_CASE("a frozen pass survives edits and a replay, and is replayed when unfrozen") {
    SmallLab small;
    pause(small);
    const float before = small.shown();
    small.lab().frames().passes().toggle(PassSwitch::freeze, "sum");
    small.lab().player().play();
    small.update(5);
    CHECK(small.shown() == before);
    small.write_by_rename("show.frag", replaced(small_look::show, "* gain", "* gain * 4.0"));
    REQUIRE(small.update_until([&] { return small.shown() == 4 * before; }));
    pause(small);
    small.lab().edit([](Document& document) { document.set_value("step_size", Value(2.0)); });
    REQUIRE(small.update_until([&] { return !small.lab().is_moving(); }));
    CHECK(small.shown() == 4 * before);
    small.lab().frames().passes().toggle(PassSwitch::freeze, "sum");
    REQUIRE(small.update_until([&] { return !small.lab().is_moving(); }));
    const float replayed = std::min(small.frames(), 20.0f);  // settle_frames
    CHECK(small.shown() == 4 * 2 * replayed);
}

TEST_CASE("another look resets the pass switches, and another preset keeps them") {
    SmallLab small;
    small.lab().frames().passes().toggle(PassSwitch::solo, "sum");
    small.lab().looks().open("small");
    REQUIRE(small.update_until([&] { return !small.lab().loader().is_loading(); }));
    CHECK(small.lab().frames().passes().switches().solo == "sum");
    small.lab().looks().duplicate("other");
    REQUIRE(small.update_until([&] { return small.document().look().id == "other"; }));
    CHECK(small.lab().frames().passes().switches().is_empty());
}

TEST_CASE("a solo or stopped pass is shown as the picture, without later passes") {
    SmallLab small;
    auto views = Views::make();
    REQUIRE(views.has_value());
    small.write_by_rename("sum.frag",
                          replaced(small_look::sum, "+ step_size", "* 0.0 + 0.25 * step_size"));
    small.lab().edit([](Document& document) { document.set_value("gain", Value(2.0)); });
    REQUIRE(small.update_until([&] { return small.shown() == 0.5f; }));
    pause(small);
    CHECK(displayed_value(small.lab(), *views) == 128);  // the last pass is display-encoded
    small.lab().frames().passes().toggle(PassSwitch::solo, "sum");
    small.update(1);
    CHECK(displayed_value(small.lab(), *views) == 137);  // linear 0.25 in sRGB: 0.5371
    CHECK(small.shown() == 0.5f);
    small.lab().frames().passes().toggle(PassSwitch::stop, "sum");
    CHECK(small.lab().frames().passes().switches().solo.empty());
    small.lab().edit([](Document& document) { document.set_value("gain", Value(3.0)); });
    small.update(2);
    CHECK(displayed_value(small.lab(), *views) == 137);
    CHECK(small.shown() == 0.5f);
    small.lab().frames().passes().toggle(PassSwitch::stop, "sum");
    small.update(2);
    CHECK(displayed_value(small.lab(), *views) == 191);  // 0.75
}

TEST_CASE("the history of one pass or all can be cleared, also in a static picture") {
    SmallLab small;
    pause(small);
    small.lab().frames().passes().clear_history("sum");
    small.update(1);
    CHECK(small.shown() == 1.0f);
    small.lab().player().play();
    small.update(4);
    CHECK(small.shown() == 5.0f);
    small.lab().frames().passes().clear_history();
    small.update(1);
    CHECK(small.shown() == 1.0f);
}

TEST_CASE("a probed pixel is in texels of the displayed pass") {
    SmallLab small(replaced(small_look::manifest, R"("format": "rgba32f", "inputs": { "previous")",
                            R"("format": "rgba32f", "scale": 0.5, "inputs": { "previous")"));
    const auto probe = [&] {
        return picture_probe(small.lab().renderer()->executor(),
                             small.lab().frames().passes().picture_pass(),
                             small.lab().work().size.extent(), {5.5, 6.9});
    };
    CHECK(probe() == Probe{"show", 5, 6, false, {8, 8}});
    small.lab().frames().passes().toggle(PassSwitch::solo, "sum");
    CHECK(probe() == Probe{"sum", 2, 3, false, {4, 4}});
}
