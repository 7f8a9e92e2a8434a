#include "graph/looks.h"
#include "lab/inspect/thumbnails.h"

#include <cmath>

namespace {
Pass shade(const std::string& name) {
    return pass(name, "uniform float u_time;\nvoid main() { color = vec4(vec3(u_time), 1); }\n");
}

// The output of the look is display-encoded, so values are shown unchanged.
int grey(const Thumbnails& thumbnails, std::size_t pass) {
    const gpu::Texture* picture = thumbnails.picture(pass);
    return picture ? static_cast<int>(std::lround(gpu::read_pixel(*picture, 3, 3)[0] * 255.0f))
                   : -1;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "one thumbnail at a time is redrawn, five times per second") {
    auto viewer = Viewer::make();
    REQUIRE(viewer.has_value());
    Look look = look_of({shade("a"), shade("b")});
    for (Pass& pass : look.passes)
        pass.output = Encoding::display;
    Executor executor = executor_of(look, {16, 8});
    Thumbnails thumbnails;
    const auto update = [&](int number, double seconds) {
        executor.draw(frame(number));
        thumbnails.update(*viewer, executor, {}, 8, seconds);
    };
    update(6, 1.0);  // 6/60 s: 0.1
    CHECK(grey(thumbnails, 0) == 26);
    CHECK(grey(thumbnails, 1) == -1);
    update(12, 1.01);
    CHECK(grey(thumbnails, 1) == 51);
    update(30, 1.1);  // too early
    CHECK(grey(thumbnails, 0) == 26);
    update(30, 1.22);
    CHECK(grey(thumbnails, 0) == 128);
    CHECK(grey(thumbnails, 1) == 51);
    REQUIRE(thumbnails.picture(0));
    CHECK(thumbnails.picture(0)->extent() == Extent{16, 8});
    CHECK(thumbnails.is_pending());
    for (const double seconds : {2.0, 2.01})  // the picture is static
        thumbnails.update(*viewer, executor, {}, 8, seconds);
    CHECK(grey(thumbnails, 1) == 128);
    CHECK_FALSE(thumbnails.is_pending());
    thumbnails.update(*viewer, executor, {}, 0, 3.0);  // not displayed
    CHECK(thumbnails.picture(0) == nullptr);
    CHECK_FALSE(thumbnails.is_pending());
}

TEST_CASE_FIXTURE(Headless, "a thumbnail is stale half a second after values changed") {
    auto viewer = Viewer::make();
    REQUIRE(viewer.has_value());
    Executor executor = executor_of(look_of({shade("a"), shade("b")}), {16, 8});
    Thumbnails thumbnails;
    const Values changed{{"gain", Value(2.0)}};
    const auto update = [&](int number, const Values& values, double seconds) {
        executor.draw(frame(number));
        thumbnails.update(*viewer, executor, values, 8, seconds);
    };
    update(1, {}, 1.0);
    update(2, {}, 1.01);
    update(3, {}, 3.0);
    CHECK_FALSE(thumbnails.is_stale(0));  // old, but with the same values
    CHECK_FALSE(thumbnails.is_stale(1));
    update(4, changed, 3.1);  // none is due
    CHECK_FALSE(thumbnails.is_stale(0));
    thumbnails.update(*viewer, executor, changed, 8, 3.15);
    update(5, changed, 3.7);
    CHECK(thumbnails.is_stale(0) != thumbnails.is_stale(1));  // one was drawn
    update(6, changed, 4.0);
    CHECK_FALSE(thumbnails.is_stale(0));
    CHECK_FALSE(thumbnails.is_stale(1));
}

TEST_CASE_FIXTURE(Headless, "values without an effect on the picture make no thumbnail stale") {
    auto viewer = Viewer::make();
    REQUIRE(viewer.has_value());
    Executor executor = executor_of(look_of({shade("a")}), {16, 8});
    Thumbnails thumbnails;
    executor.draw(frame(1));
    thumbnails.update(*viewer, executor, {}, 8, 1.0);
    for (const double seconds : {2.0, 3.0, 4.0})
        thumbnails.update(*viewer, executor, {{"gain", Value(2.0)}}, 8, seconds);
    CHECK_FALSE(thumbnails.is_stale(0));
}
