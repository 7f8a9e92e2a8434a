// A pass that is drawn directly onto the target of its reader gives the same result as with its own
// target.
#include "graph/executor/nan_watch.h"
#include "graph/looks.h"
#include "graph/programs/specialized_look.h"

#include <limits>

namespace {
// New light in each frame, and its glow, of which half is kept. The light also writes alpha, which
// the glow ignores.
Look glowing_look() {
    Pass light =
        pass("light", "uniform int u_frame;\nvoid main() { color = vec4(u_frame, uv.x, 0, 7); }\n");
    light.blend = Blend::add;
    light.onto = Onto{"glow", "$plain"};
    Pass glow = pass("glow",
                     "uniform sampler2D now; uniform sampler2D before; uniform bool u_drawn_onto;\n"
                     "void main() {\n"
                     "    color = vec4(0.5 * texture(before, uv).rgb, 1.0);\n"
                     "    color.b = u_drawn_onto ? 1.0 : 0.0;\n"
                     "    if (!u_drawn_onto)\n"
                     "        color.rgb += texture(now, uv).rgb;\n"
                     "}\n",
                     {reads("now", "light"), reads("before", "glow", 1)});
    Pass show =
        pass("show", "uniform sampler2D image;\nvoid main() { color = texture(image, uv); }\n",
             {reads("image", "glow")});
    return look_of({light, glow, show}, {parameter_named("plain", {}, 1.0, {})});
}

const std::vector<bool> last_only{false, false, true};

Executor sharing(const Look& look) {
    Executor executor = executor_of(look, {4, 4});
    REQUIRE(executor.set_displayed(last_only).has_value());
    return executor;
}

// The glow after n frames, where frame i adds i and the sum is halved each frame.
float glow_after(int frames) {
    float glow = 0.0f;
    for (int n = 1; n <= frames; ++n)
        glow = 0.5f * glow + static_cast<float>(n);
    return glow;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a pass drawn onto another target is added to it, except for alpha") {
    Executor executor = sharing(glowing_look());
    CHECK(executor.plan().targets[0].onto == 1);
    for (int n = 1; n <= 4; ++n) {
        executor.draw(frame(n));
        CHECK(pixel(executor, 2)[0] == glow_after(n));
        CHECK(pixel(executor, 2)[2] == 1.0f);  // the program's uniform is set
        CHECK(pixel(executor, 2)[3] == 1.0f);
        CHECK(executor.drawer().draw_calls() == 3);
    }
    // At 16 bytes per texel: the previous glow is read, the glow written and read, the picture
    // written.
    CHECK(bytes_per_pixel(executor) == 4 * 16.0);
    REQUIRE(executor.set_displayed({}).has_value());
    CHECK(bytes_per_pixel(executor) == 6 * 16.0);  // also the light is written and read
}

TEST_CASE_FIXTURE(Headless,
                  "a pass drawn onto another target is drawn separately when its picture is read") {
    Executor executor = sharing(glowing_look());
    for (int n = 1; n <= 3; ++n) {
        executor.draw(frame(n));
        if (n == 2)
            continue;  // not read
        CHECK(pixel(executor, 0) == Rgba{static_cast<float>(n), 0.125f, 0.0f, 7.0f});
        CHECK(pixel(executor, 0, 3)[1] == 0.875f);
        CHECK(red(executor, 2) == glow_after(n));
        CHECK(executor.drawer().draw_calls() == 3);
    }
    executor.redraw(frame(9), {false, false, true});  // the pass drawn onto it is unchanged
    CHECK(red(executor, 0) == 3.0f);
    executor.redraw(frame(4), {true, false, true});
    CHECK(red(executor, 0) == 4.0f);
    REQUIRE(executor.set_displayed({}).has_value());  // it has its own target again
    executor.draw(frame(5));
    CHECK(red(executor, 0) == 5.0f);
}

TEST_CASE_FIXTURE(Headless, "history continues when a sharing pass becomes displayed or hidden") {
    Executor executor = sharing(glowing_look());
    const std::vector<bool> seen[] = {{}, last_only, {true, false, true}, {false, true, true}};
    for (int n = 1; n <= 8; ++n) {
        REQUIRE(executor.set_displayed(seen[n % 4]).has_value());
        executor.draw(frame(n));
        CHECK(pixel(executor, 2)[0] == glow_after(n));
        if (n % 4 != 1)
            CHECK(executor.plan().targets[0].onto == std::nullopt);
        if (n % 4 == 0 || n % 4 == 2)
            CHECK(red(executor, 0) == static_cast<float>(n));
    }
}

TEST_CASE_FIXTURE(Headless, "slices and redraws give a shared target the same content") {
    Executor executor = sharing(glowing_look());
    executor.draw(frame(1));
    for (int n = 2; n <= 4; ++n) {
        executor.draw(frame(n), nullptr, n % 2 == 0 ? Slices::double_buffered : Slices::in_place);
        while (!executor.drawer().continue_frame(1e-9)) {
        }
        CHECK(red(executor, 2) == glow_after(n));
    }
    executor.redraw(frame(4), {false, true, true});  // the light must be drawn with the glow
    CHECK(red(executor, 2) == glow_after(4));
    executor.redraw(frame(4), {true, false, true});
    CHECK(red(executor, 2) == glow_after(4));
    executor.redraw(frame(4), {false, true, true}, Slices::double_buffered);
    while (!executor.drawer().continue_frame(1e-9)) {
    }
    CHECK(red(executor, 2) == glow_after(4));
    executor.drawer().warm_up_pass(frame(5), 0);  // it must return without an error
    executor.clear_history();
    executor.draw(frame(1));
    CHECK(red(executor, 2) == glow_after(1));
}

TEST_CASE_FIXTURE(Headless, "a frozen or left-out pass gets its own target again") {
    Executor executor = sharing(glowing_look());
    executor.draw(frame(1));
    REQUIRE(executor.set_runs({PassRun::frozen, PassRun::drawn, PassRun::drawn}).has_value());
    CHECK_FALSE(executor.plan().targets[0].onto.has_value());
    executor.draw(frame(2));  // it is empty, and so is drawn once
    executor.draw(frame(3));
    CHECK(red(executor, 2) == 0.5f * (0.5f * 1.0f + 2.0f) + 2.0f);
    REQUIRE(executor.set_runs({}).has_value());
    executor.draw(frame(4));
    CHECK(red(executor, 2) == 0.5f * 3.25f + 4.0f);
    CHECK(executor.plan().targets[0].onto == 1);
    CHECK(read_dependencies_of(executor, last_only) == std::vector<bool>{true, true, true});
}

TEST_CASE_FIXTURE(Headless, "non-finite values are found in the target that they were drawn onto") {
    Look look = glowing_look();
    look.passes[0].fragment = fragment(
        "uniform int u_frame;\nvoid main() { color = vec4(u_frame == 2 ? 1.0 / 0.0 : 1.0); "
        "}\n");
    Executor executor = sharing(look);
    const auto nan_watch = std::make_shared<NanWatch>();
    REQUIRE(nan_watch->set_policy(NanPolicy::clamp, executor).has_value());
    executor.draw(frame(1));
    CHECK_FALSE(nan_watch->take(executor, true).has_value());
    executor.draw(frame(2));
    const auto trip = nan_watch->take(executor, true);
    REQUIRE(trip.has_value());
    CHECK(trip->pass == 1);
    CHECK(red(executor, 2) < std::numeric_limits<float>::infinity());
}

TEST_CASE_FIXTURE(Headless,
                  "an edit redetermines which passes share a target, and feedback continues") {
    Executor executor = sharing(glowing_look());
    executor.draw(frame(1));
    Look edited = glowing_look();
    edited.passes[0].onto.reset();
    REQUIRE(executor.replace(edited, programs_of(edited)).has_value());
    CHECK_FALSE(executor.plan().targets[0].onto.has_value());
    executor.draw(frame(2));
    CHECK(red(executor, 2) == glow_after(2));
    REQUIRE(executor.replace(glowing_look(), programs_of(glowing_look())).has_value());
    executor.draw(frame(3));
    CHECK(executor.plan().targets[0].onto == 1);
    CHECK(red(executor, 2) == glow_after(3));
}

TEST_CASE_FIXTURE(Headless,
                  "programs specialised for a shared target are dropped when sharing changes") {
    Look look = glowing_look();
    std::swap(look.passes[0], look.passes[1]);  // drawn in the same order, shared or not
    Executor executor = sharing(look);
    REQUIRE(executor.plan().targets[1].onto == 0);
    SpecializedTexts texts;
    const auto nothing_moves = [](const Parameter&) { return false; };
    executor.specialize(
        programs_of(specialized_look(look, {}, executor.plan(), nothing_moves, texts)), {});
    executor.draw(frame(1));
    CHECK(executor.programs().is_specialized());
    CHECK(pixel(executor, 2)[2] == 1.0f);
    REQUIRE(executor.set_displayed({}).has_value());
    executor.draw(frame(2));
    CHECK(pixel(executor, 2)[2] == 0.0f);
}
