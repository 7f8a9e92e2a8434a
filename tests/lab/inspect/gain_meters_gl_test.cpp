#include "gpu/objects/draw.h"
#include "lab/inspect/gain_meters.h"
#include "lab/small_lab.h"

namespace {
/// A look whose first pass is 1 after a frame and grows by 1 per frame. The second pass is a
/// quarter of it.
struct Metered : SmallLab {
    std::optional<LevelMeters> meters;

    Metered() {
        auto programs = MeterPrograms::make();
        REQUIRE(programs.has_value());
        meters.emplace(std::make_shared<const MeterPrograms>(std::move(*programs)));
        lab().player().pause();
        lab().edit([](Document& document) { document.set_value("gain", Value(0.25)); });
        REQUIRE(update_until([&] { return !lab().is_moving(); }));
    }
    void measure(double seconds) {
        meters->update(lab().renderer()->executor(), document().values(), seconds);
        gpu::finish();
    }
    double peak(std::size_t pass) { return meters->gain(pass) ? meters->gain(pass)->peak : -1.0; }
};
}  // namespace

TEST_CASE("one pass is measured per update, and again after a change") {
    Metered lab;
    lab.measure(10.0);
    CHECK(lab.meters->gain(0) == nullptr);
    CHECK(lab.meters->is_pending());
    lab.measure(10.0);  // the result is available
    CHECK(lab.meters->gain(1) == nullptr);
    lab.measure(10.0);
    REQUIRE(lab.meters->gain(0));
    const auto frames = static_cast<double>(lab.frames());
    CHECK(lab.peak(0) == frames);
    CHECK(lab.meters->gain(0)->mean == frames);
    CHECK(lab.meters->gain(0)->clipped == 0.0);
    CHECK(lab.peak(1) == frames / 4.0);
    CHECK_FALSE(lab.meters->is_pending());

    lab.lab().player().step();
    lab.update(1);
    REQUIRE(lab.frames() == static_cast<float>(frames + 1.0));
    lab.measure(10.1);  // too early
    lab.measure(10.1);
    CHECK(lab.peak(0) == frames);
    lab.measure(1000.0);
    lab.measure(1000.0);
    CHECK(lab.peak(0) == frames + 1.0);
    CHECK(lab.peak(1) == frames / 4.0);
    lab.measure(1000.0);
    CHECK(lab.peak(1) == (frames + 1.0) / 4.0);
    lab.meters->stop();
    CHECK(lab.meters->gain(0) == nullptr);
}

TEST_CASE("a static picture is measured again after a value changes") {
    Metered lab;
    for (int update = 0; update < 3; ++update)
        lab.measure(10.0);
    lab.lab().edit([](Document& document) { document.set_value("gain", Value(0.5)); });
    lab.update(1);
    // Waits until the GPU has checked the picture for NaN and infinity.
    CHECK(lab.update_until([&] { return !lab.lab().is_moving(); }));
    for (const double seconds : {20.0, 21.0, 22.0, 23.0})
        lab.measure(seconds);
    CHECK(lab.peak(1) == static_cast<double>(lab.frames()) / 2.0);
}
