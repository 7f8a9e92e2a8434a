#include "gpu/headless.h"
#include "gpu/objects/canvas.h"
#include "gpu/objects/draw.h"
#include "gpu/objects/timer.h"

TEST_CASE_FIXTURE(Headless,
                  "a timer has no result at first, and a positive time after work is done") {
    auto canvas = gpu::Canvas::make({512, 512}, Format::rgba32f);
    REQUIRE(canvas.has_value());
    gpu::Timer timer;
    CHECK_FALSE(timer.milliseconds().has_value());
    for (int frame = 0; frame < 10; ++frame) {  // more than the ring holds
        timer.begin();
        canvas->clear({1, 1, 1, 1});
        timer.end();
    }
    gpu::finish();
    REQUIRE(timer.milliseconds().has_value());
    CHECK(*timer.milliseconds() > 0.0);
    CHECK(*timer.milliseconds() < 10000.0);
}
