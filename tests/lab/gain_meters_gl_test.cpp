#include "gpu/draw.h"
#include "lab/gain_meters.h"
#include "lab/small_lab.h"

namespace {
/// A look whose first pass is 1 after a frame, and 1 more after each; the second a fourth of it.
struct Metered : SmallLab {
    Result<GainMeters> meters = GainMeters::make();

    Metered() {
        lab().transport().pause();
        lab().edit([](Document& document) { document.set_value("gain", Value(0.25)); });
        REQUIRE(turn_until([&] { return !lab().is_moving(); }));
    }
    void update(bool is_moving, double seconds) {
        meters->update(lab().renderer()->executor(), document().values(), is_moving, seconds);
        gpu::finish();
    }
};
}  // namespace

TEST_CASE("one pass in turn is measured, five times a second") {
    Metered lab;
    REQUIRE(lab.meters.has_value());
    lab.update(true, 10.0);
    CHECK(lab.meters->gain(0) == nullptr);
    lab.update(true, 10.0);  // the answer has come
    REQUIRE(lab.meters->gain(0));
    CHECK(lab.meters->gain(1) == nullptr);
    lab.update(true, 10.1);  // too early
    lab.update(true, 10.1);
    CHECK(lab.meters->gain(1) == nullptr);
    lab.update(true, 1000.0);
    lab.update(true, 1000.0);
    REQUIRE(lab.meters->gain(1));
    const auto frames = static_cast<double>(lab.frames());
    CHECK(lab.meters->gain(0)->peak == frames);
    CHECK(lab.meters->gain(0)->mean == frames);
    CHECK(lab.meters->gain(0)->clipped == 0.0);
    CHECK(lab.meters->gain(1)->peak == frames / 4.0);
    lab.meters->stop();
    CHECK(lab.meters->gain(0) == nullptr);
}

TEST_CASE("what rests is measured once, all of it") {
    Metered lab;
    for (int turn = 0; turn < 4; ++turn)
        lab.update(false, 10.0);
    CHECK(lab.meters->gain(0));
    CHECK(lab.meters->gain(1));
}
