// Passes that accumulate: their content, when they restart, and when they have converged.
#include "gpu/objects/draw.h"
#include "graph/looks.h"

#include <doctest/doctest.h>

namespace {
/// Each draw adds one to red and the previous number of samples to green; blue is a parameter.
Look counting(int repeat = 1) {
    Look look =
        look_of({pass("sum",
                      "uniform int u_samples;\nuniform float shade;\n"
                      "void main() { color = vec4(1, u_samples, shade, 0); }\n"),
                 pass("show",
                      "uniform sampler2D sum;\nuniform float gain;\nuniform int u_samples;\n"
                      "void main() { color = vec4(gain * texture(sum, uv).r, u_samples, 0, 1); }\n",
                      {reads("sum", "sum")})},
                {parameter_named("shade", {}, 0.0, {{0, "shade"}}),
                 parameter_named("gain", {}, 1.0, {{1, "gain"}}),
                 parameter_named("rounds", {Scalar::integer}, 2.0, {}),
                 parameter_named("enough", {Scalar::integer}, 3.0, {})});
    look.passes[0].accumulate = true;
    look.passes[0].blend = Blend::add;
    look.passes[0].repeat = repeat;
    return look;
}

void draw(Executor& executor, int first, int last) {
    for (int n = first; n <= last; ++n)
        executor.draw(frame(n));
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "an accumulating pass sums all repetitions of all frames") {
    Executor executor = executor_of(counting(2));
    draw(executor, 1, 2);
    CHECK(pixel(executor, 0) == Rgba{4, 0 + 1 + 2 + 3, 0, 0});
    CHECK(executor.drawer().samples() == Samples{4, {}});
    executor.draw(frame(1));  // a restart
    CHECK(pixel(executor, 0) == Rgba{2, 0 + 1, 0, 0});
}

TEST_CASE_FIXTURE(Headless, "a later pass reads the number of accumulated samples") {
    Executor executor = executor_of(counting(5));
    draw(executor, 1, 3);
    CHECK(pixel(executor, 1) == Rgba{15, 15, 0, 1});
}

TEST_CASE_FIXTURE(Headless, "samples restart only when something that affects them changes") {
    Executor executor = executor_of(counting());
    draw(executor, 1, 3);
    int left = 1;
    SUBCASE("a value of the pass") {
        executor.set_values({{"shade", 0.5}});
    }
    SUBCASE("another size") {
        REQUIRE(executor.resize({6, 4}, {}));
    }
    SUBCASE("an edited look") {
        const Look look = counting();
        REQUIRE(executor.replace(look, programs_of(look)));
    }
    SUBCASE("an edited look with the same programs") {
        const Look look = counting();
        REQUIRE(executor.replace(look, programs_of(look, &executor.programs().generic())));
    }
    SUBCASE("an explicit restart") {
        executor.drawer().restart_samples();
    }
    SUBCASE("a value of a later pass") {
        executor.set_values({{"gain", 2.0}});
        left = 4;
    }
    SUBCASE("the same value and size") {
        executor.set_values({{"shade", 0.0}});
        REQUIRE(executor.resize({4, 4}, {}));
        left = 4;
    }
    SUBCASE("the mouse, which the pass does not read") {
        executor.drawer().note_mouse_moved();
        left = 4;
    }
    executor.draw(frame(4));
    CHECK(red(executor, 0) == left);
}

TEST_CASE_FIXTURE(Headless, "a source, an image or the mouse restarts the passes that read it") {
    Look look = counting();
    look.passes[0].fragment = fragment(
        "uniform sampler2D picture; uniform sampler2D lut; uniform vec2 u_mouse;\n"
        "void main() { color = vec4(1.0 + min(u_mouse.x, 0.0)) +\n"
        "                      0.0 * (texture(picture, uv) + texture(lut, uv)); }\n");
    look.passes[0].inputs = {{"picture", Input::From::source, "", 0, {}},
                             {"lut", Input::From::image, "lut", 0, {}}};
    look.images = {{"lut", "lut.png", {}, false}};
    look.driven_by = Driver::picture;
    Executor executor = executor_of(look);
    draw(executor, 1, 3);
    const Picture white{{1, 1}, 3, Encoding::linear, {1, 1, 1}};
    SUBCASE("a new source") {
        REQUIRE(executor.set_source(white));
    }
    SUBCASE("a new image") {
        REQUIRE(executor.set_image("lut", white));
    }
    SUBCASE("a moved mouse") {
        executor.drawer().note_mouse_moved();
    }
    executor.draw(frame(4));
    CHECK(red(executor, 0) == 1);
}

TEST_CASE_FIXTURE(Headless, "a pass stops at its target number of samples") {
    Look look = counting(2);
    look.passes[0].converge = Count("enough");
    Executor executor = executor_of(look);
    CHECK_FALSE(executor.drawer().has_converged());
    executor.draw(frame(1));
    CHECK_FALSE(executor.drawer().has_converged());
    executor.draw(frame(2));
    CHECK(executor.drawer().has_converged());
    CHECK(executor.drawer().samples() == Samples{3, 3});
    executor.draw(frame(3));
    CHECK(red(executor, 0) == 3);
    CHECK(executor.drawer().draw_calls() == 1);  // only the pass that shows it
    executor.set_values({{"enough", 5.0}});      // more samples of the same kind
    CHECK_FALSE(executor.drawer().has_converged());
    executor.draw(frame(4));
    CHECK(red(executor, 0) == 5);
    executor.set_values({{"enough", 5.0}, {"shade", 1.0}});
    CHECK_FALSE(executor.drawer().has_converged());
}

TEST_CASE_FIXTURE(Headless, "the number of samples per frame does not restart accumulation") {
    Look look = counting();
    look.passes[0].repeat = "rounds";
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    executor.set_values({{"rounds", 7.0}});
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 2 + 7);
}

TEST_CASE_FIXTURE(Headless,
                  "a pass that converges after 0 samples shows each frame's samples alone") {
    Look look = counting(3);
    look.passes[0].converge = 0;
    Executor executor = executor_of(look);
    draw(executor, 1, 4);
    CHECK(red(executor, 0) == 3);
    CHECK_FALSE(executor.drawer().has_converged());
}

TEST_CASE_FIXTURE(Headless,
                  "a look that also depends on time, a signal or history never converges") {
    Look look = counting();
    look.passes[0].converge = 1;
    SUBCASE("time") {
        look.passes[1].fragment =
            fragment("uniform float u_time;\nvoid main() { color = vec4(u_time); }\n");
        look.passes[1].inputs.clear();
    }
    SUBCASE("a signal") {
        look.driven_by = Driver::signal;
    }
    SUBCASE("history") {
        look.passes[1].inputs = {reads("sum", "show", 1)};
    }
    Executor executor = executor_of(look);
    draw(executor, 1, 3);
    CHECK_FALSE(executor.drawer().has_converged());
    CHECK(executor.drawer().samples() == Samples{1, 1});
}

TEST_CASE_FIXTURE(Headless, "a redraw keeps the samples and adds none") {
    Executor executor = executor_of(counting());
    draw(executor, 1, 3);
    executor.set_values({{"gain", 2.0}});
    executor.redraw(frame(3), {true, true});
    CHECK(red(executor, 0) == 3);
    CHECK(red(executor, 1) == 6);
}

TEST_CASE_FIXTURE(Headless, "a frame with a time limit draws fewer samples") {
    Executor executor = executor_of(counting(64));
    Frame now = frame(1);
    now.sample_budget_seconds = 1e-9;
    executor.draw(now);
    CHECK(executor.drawer().samples() == Samples{1, {}});
    gpu::finish();
    now = frame(2);
    now.sample_budget_seconds = 1e-9;
    executor.draw(now);
    CHECK(executor.drawer().samples() == Samples{2, {}});
    now = frame(3);
    now.sample_budget_seconds = 1e9;  // all samples if there is time
    executor.draw(now);
    CHECK(executor.drawer().samples()->held == 2 + 64);
}

TEST_CASE_FIXTURE(Headless,
                  "a running mean by alpha equals the mean, also in a target with history") {
    Look look = look_of(
        {pass("mean",
              "uniform int u_samples; uniform int u_frame;\n"
              "void main() { color = vec4(vec3(u_frame), 1.0 / float(u_samples + 1)); }\n"),
         pass("old", "uniform sampler2D past;\nvoid main() { color = texture(past, uv); }\n",
              {reads("past", "mean", 1)})});
    look.passes[0].accumulate = true;
    look.passes[0].blend = Blend::alpha;
    look.passes[0].converge = 5;
    Executor executor = executor_of(look);
    draw(executor, 1, 5);
    CHECK(red(executor, 0) == doctest::Approx(3.0));  // the mean of 1 to 5
    CHECK(red(executor, 1) == doctest::Approx(2.5));  // of 1 to 4
    draw(executor, 6, 8);
    CHECK(red(executor, 0) == doctest::Approx(3.0));  // converged
    CHECK(red(executor, 1) == doctest::Approx(3.0));
}
