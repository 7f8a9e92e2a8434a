#include "gpu/objects/draw.h"
#include "graph/looks.h"
#include "lab/inspect/inspection.h"

namespace {
struct Inspecting : Headless {
    std::optional<Inspection> inspection;
    Result<gpu::Canvas> target = gpu::Canvas::make({16, 16}, Format::rgba32f);
    Inspection::Subject subject{"beam", Channels::color, {0, 4}};

    Inspecting() {
        auto programs = MeterPrograms::make();
        REQUIRE(programs.has_value());
        inspection.emplace(std::make_shared<const MeterPrograms>(std::move(*programs)));
    }
    void show(float number) { target->clear({number, number, number, 1}); }
    // Enough updates for pending results.
    void update(double seconds) {
        REQUIRE((inspection && target));
        for (int i = 0; i < 3; ++i) {
            inspection->update(target->texture(), subject, seconds);
            gpu::finish();
        }
    }
    double mean() { return inspection->statistics().value().mean; }
};
}  // namespace

TEST_CASE_FIXTURE(Inspecting, "a target is measured at most five times per second") {
    show(1);
    update(1000.0);
    update(1100.0);  // the first measurement takes longer
    CHECK(mean() == 1.0);
    show(2);
    update(1100.19);
    CHECK(mean() == 1.0);
    update(1200.0);
    CHECK(mean() == 2.0);
}

TEST_CASE_FIXTURE(Inspecting, "the histogram follows the black and white points at once") {
    show(3);
    update(1000.0);
    CHECK(inspection->histogram().bins[0][96] == 256);  // three quarters of 128
    subject.levels = {0, 6};
    update(1000.01);
    CHECK(inspection->histogram().bins[0][64] == 256);
    subject.levels = {0, 2};
    update(1000.02);
    CHECK(inspection->histogram().above == 3 * 256);
}

TEST_CASE_FIXTURE(Inspecting, "statistics are cleared for another pass and after the end") {
    show(1);
    update(1000.0);
    subject.pass = "bloom";
    update(1000.01);
    CHECK_FALSE(inspection->statistics().has_value());
    update(1100.0);
    CHECK(mean() == 1.0);
    inspection->stop();
    CHECK_FALSE(inspection->statistics().has_value());
    CHECK(inspection->histogram().bins.empty());
}
