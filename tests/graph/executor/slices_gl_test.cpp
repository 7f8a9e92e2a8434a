// A frame drawn in slices equals a frame drawn at once.
#include "graph/looks.h"

namespace {
// No time budget: each slice is one band with the minimum number of rows.
constexpr double shortest = 1e-9;

int slices_of(Executor& executor) {
    int slices = 1;
    while (!executor.drawer().continue_frame(shortest))
        ++slices;
    return slices;
}

// Each pass varies per pixel, so that a lost or repeated band is detected.
Look busy_look() {
    Pass noise = pass("noise",
                      "uniform float u_time;\nvoid main() { color = "
                      "vec4(fract(uv.xyx * (7.0 + u_time)), 1); }\n");
    Pass trail = pass("trail",
                      "uniform sampler2D now; uniform sampler2D before;\nvoid main() { color = "
                      "texture(now, uv) + 0.5 * texture(before, uv) + vec4(dFdx(uv.x), dFdy(uv.y), "
                      "0, 0); }\n",
                      {reads("now", "noise"), reads("before", "trail", 1)});
    Pass relax = pass("relax",
                      "uniform sampler2D mine; uniform sampler2D image;\nvoid main() { color = "
                      "0.25 * texture(mine, uv) + texture(image, uv); }\n",
                      {reads("mine", "relax", 1), reads("image", "trail")});
    relax.repeat = 3;
    Pass glow = pass("glow",
                     "uniform sampler2D image; uniform sampler2D older;\nvoid main() { color = "
                     "textureLod(image, uv, 2.0) + texture(older, uv).bgra; }\n",
                     {reads("image", "relax", 0, {Filter::linear, Wrap::edge, true}),
                      reads("older", "trail", 2)});
    glow.rows = RowOrder::top_first;
    glow.draw = Draw::quad;
    Pass after = pass(
        "after", "uniform sampler2D image;\nvoid main() { color = 2.0 * texture(image, uv); }\n",
        {reads("image", "relax")});
    return look_of({noise, trail, relax, after, glow});
}

void check_same(const Executor& sliced, const Executor& whole) {
    for (int i = 0; i < static_cast<int>(whole.look().passes.size()); ++i) {
        CAPTURE(i);
        CHECK(gpu::read_picture(sliced.target(i)) == gpu::read_picture(whole.target(i)));
    }
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a look drawn in slices equals one drawn at once") {
    constexpr Extent extent{33, 27};
    Executor whole = executor_of(busy_look(), extent);
    Executor sliced = executor_of(busy_look(), extent);
    for (int n = 1; n <= 6; ++n) {
        whole.draw(frame(n));
        const bool is_beside = n % 2 == 0;
        sliced.draw(frame(n), nullptr, is_beside ? Slices::double_buffered : Slices::in_place);
        CHECK(sliced.drawer().has_unfinished_frame());
        // 27 rows are 13 pairs and one row, for each of 1 + 1 + 3 + 1 draws, with pass ends
        // between.
        const int slices = slices_of(sliced);
        CHECK(slices > 6);
        CHECK_FALSE(sliced.drawer().has_unfinished_frame());
        CHECK(sliced.drawer().draw_calls() == whole.drawer().draw_calls());
        check_same(sliced, whole);
    }
    sliced.draw(frame(7));
    whole.draw(frame(7));
    check_same(sliced, whole);
}

TEST_CASE_FIXTURE(Headless, "until a frame is complete, the previous one is shown") {
    Executor executor = executor_of(look_of({counter()}), {8, 8});
    executor.draw(frame(1));
    executor.draw(frame(2), nullptr, Slices::double_buffered);
    const auto number = executor.textures().number();
    int slices = 0;
    while (!executor.drawer().continue_frame(shortest)) {
        CHECK(red(executor, 0, 0, 0) == 1.0f);
        CHECK(red(executor, 0, 7, 7) == 1.0f);
        CHECK(executor.textures().number() == number);
        ++slices;
    }
    CHECK(slices >= 1);
    CHECK(red(executor, 0, 0, 0) == 2.0f);
    CHECK(red(executor, 0, 7, 7) == 2.0f);
    CHECK(executor.textures().number() != number);
}

TEST_CASE_FIXTURE(Headless,
                  "a redraw in slices reads the same inputs, and is shown when complete") {
    Parameter gain = parameter_named("gain", {}, 1.0, {{1, "gain"}});
    Pass show = pass("show",
                     "uniform sampler2D image; uniform float gain;\nvoid main() { color = "
                     "gain * texture(image, uv); }\n",
                     {reads("image", "counter")});
    Executor executor = executor_of(look_of({counter(), show}, {gain}), {8, 8});
    for (int n = 1; n <= 3; ++n)
        executor.draw(frame(n));
    executor.set_values({{"gain", 10.0}});
    executor.redraw(frame(3), {true, true}, Slices::double_buffered);
    CHECK_FALSE(executor.drawer().continue_frame(shortest));
    CHECK(red(executor, 1, 0, 0) == 3.0f);
    slices_of(executor);
    CHECK(red(executor, 0) == 3.0f);  // two and one, not three and one
    CHECK(red(executor, 1, 0, 0) == 30.0f);
    executor.draw(frame(4));
    CHECK(red(executor, 1) == 40.0f);
}

TEST_CASE_FIXTURE(Headless, "a dropped frame leaves history unchanged") {
    Executor executor = executor_of(look_of({counter()}), {8, 8});
    executor.draw(frame(1));
    executor.draw(frame(2), nullptr, Slices::double_buffered);
    CHECK_FALSE(executor.drawer().continue_frame(shortest));
    executor.drawer().drop_frame();
    CHECK(red(executor, 0, 0, 0) == 1.0f);
    CHECK(red(executor, 0, 7, 7) == 1.0f);
    executor.draw(frame(3));
    CHECK(red(executor, 0, 0, 0) == 2.0f);
}

TEST_CASE_FIXTURE(Headless, "samples accumulate over slices, and a restart drops the frame") {
    Pass sum =
        pass("sum", "uniform int u_samples;\nvoid main() { color = vec4(1, u_samples, 0, 0); }\n");
    sum.accumulate = true;
    sum.blend = Blend::add;
    sum.repeat = 3;
    Executor executor = executor_of(look_of({sum}), {8, 8});
    executor.draw(frame(1), nullptr, Slices::in_place);
    slices_of(executor);
    executor.draw(frame(2), nullptr, Slices::double_buffered);
    slices_of(executor);
    CHECK(executor.drawer().samples()->held == 6);
    CHECK(pixel(executor, 0, 7, 7) == Rgba{6, 0 + 1 + 2 + 3 + 4 + 5, 0, 0});
    executor.draw(frame(3), nullptr, Slices::double_buffered);
    CHECK_FALSE(executor.drawer().continue_frame(shortest));
    executor.drawer().restart_samples();
    CHECK_FALSE(executor.drawer().has_unfinished_frame());
    executor.draw(frame(4));
    CHECK(pixel(executor, 0, 0, 0) == Rgba{3, 0 + 1 + 2, 0, 0});
}
