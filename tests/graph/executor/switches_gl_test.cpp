// Passes switched by the user: bypassed, frozen or left out.
#include "about.h"
#include "graph/looks.h"

namespace {
Pass numbered(const std::string& name) {
    return pass(name, "uniform int u_frame;\nvoid main() { color = vec4(u_frame); }\n");
}

// Ten times its input.
Pass tens(const std::string& name, const Input& input) {
    return pass(name,
                "uniform sampler2D image;\nvoid main() { color = 10.0 * texture(image, uv); }\n",
                {input});
}

void run(Executor& executor, std::vector<PassRun> runs) {
    REQUIRE(executor.set_runs(std::move(runs)).has_value());
}

constexpr PassRun drawn = PassRun::drawn;
constexpr PassRun bypassed = PassRun::bypassed;
constexpr PassRun frozen = PassRun::frozen;
constexpr PassRun left_out = PassRun::left_out;
}  // namespace

TEST_CASE_FIXTURE(Headless, "a bypassed pass passes on its first input at its own size") {
    Look look = look_of({numbered("number"), tens("tens", reads("image", "number")),
                         tens("more", reads("image", "tens"))});
    look.passes[1].size.fill({Side::By::pixels, 2.0, {}});
    Executor executor = executor_of(look);
    executor.draw(frame(3));
    CHECK(red(executor, 2) == 300.0f);
    run(executor, {drawn, bypassed, drawn});
    executor.draw(frame(4));
    CHECK(red(executor, 1) == 4.0f);
    CHECK(red(executor, 2) == 40.0f);
    CHECK(executor.target(1).extent() == Extent{2, 2});
    executor.redraw(frame(4), {false, true, true});  // again with the current values
    CHECK(red(executor, 2) == 40.0f);
    run(executor, {});
    executor.draw(frame(5));
    CHECK(red(executor, 2) == 500.0f);
}

TEST_CASE_FIXTURE(Headless, "a bypass uses the filter and history of its input") {
    // Texels of 0 and 1: between them linear filtering reads 0.5.
    Pass halves = pass("halves", "void main() { color = vec4(floor(uv.x * 2.0)); }\n");
    halves.size = {Side{Side::By::pixels, 2.0, {}}, Side{Side::By::pixels, 1.0, {}}};
    Input smooth = reads("image", "halves", 0, {Filter::linear, Wrap::edge, false});
    Pass middle = tens("middle", smooth);
    middle.size.fill({Side::By::pixels, 1.0, {}});
    Look look =
        look_of({halves, middle, numbered("number"), tens("late", reads("image", "number", 2))});
    Executor executor = executor_of(look);
    run(executor, {drawn, bypassed, drawn, bypassed});
    for (int n = 1; n <= 5; ++n)
        executor.draw(frame(n));
    CHECK(red(executor, 1) == about(0.5, 1e-3));
    CHECK(red(executor, 3) == 3.0f);
}

TEST_CASE_FIXTURE(Headless, "a bypass converts between integer and float targets") {
    Look look = look_of({pass("light", "void main() { color = vec4(2.75, -3.0, 0, 1); }\n"),
                         tens("whole", reads("image", "light")),
                         pass("back",
                              "uniform usampler2D image;\nvoid main() { color = "
                              "vec4(texelFetch(image, ivec2(0), 0).r); }\n",
                              {reads("image", "whole")})});
    look.passes[1].format = Format::r32ui;
    look.passes[1].fragment = {
        "test.frag",
        "#version 410 core\nuniform sampler2D image;\nin vec2 uv;\nout uvec4 "
        "color;\nvoid main() { color = uvec4(texture(image, uv)) * 10u; }\n",
        {}};
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    CHECK(red(executor, 2) == 20.0f);
    run(executor, {drawn, bypassed, bypassed});
    executor.draw(frame(2));
    CHECK(red(executor, 1) == 2.0f);
    CHECK(red(executor, 2) == 2.0f);
}

namespace {
// The value in a bypassed target of format `to`, whose input has format `from` and this number.
float passed_input(Format from, const std::string& number, Format to) {
    const auto writing = [](Format format, const std::string& value) {
        const std::string type(
            std::array{"vec4", "uvec4", "ivec4"}[static_cast<std::size_t>(sample_kind_of(format))]);
        return Stage{"test.frag",
                     "#version 410 core\nout " + type + " color;\nvoid main() { color = " + type +
                         "(" + value + "); }\n",
                     {}};
    };
    Look look = look_of({pass("given", ""), pass("whole", "", {reads("image", "given")})});
    look.passes[0].format = from;
    look.passes[0].fragment = writing(from, number);
    look.passes[1].format = to;
    look.passes[1].fragment = writing(to, "1");
    Executor executor = executor_of(look);
    run(executor, {drawn, bypassed});
    executor.draw(frame(1));
    return red(executor, 1);
}
}  // namespace

TEST_CASE_FIXTURE(Headless,
                  "a bypass keeps a number that both formats hold, else the nearest one") {
    CHECK(passed_input(Format::rgba32f, "-3.75", Format::r16i) == -3.0f);
    CHECK(passed_input(Format::rgba32f, "-3.75", Format::r16ui) == 0.0f);
    CHECK(passed_input(Format::r8i, "-128", Format::rgba32f) == -128.0f);
    CHECK(passed_input(Format::r8i, "-128", Format::r32i) == -128.0f);
    CHECK(passed_input(Format::r32i, "-5", Format::r32ui) == 0.0f);
    CHECK(passed_input(Format::r32i, "70000", Format::r32ui) == 70000.0f);
    CHECK(passed_input(Format::r32ui, "70000u", Format::r32i) == 70000.0f);
    CHECK(passed_input(Format::r32ui, "4000000000u", Format::r32i) == 2147483648.0f);  // 2^31 - 1
    CHECK(passed_input(Format::r32ui, "4000000000u", Format::r32ui) == 4000000000.0f);
}

TEST_CASE_FIXTURE(Headless, "a bypassed pass without a source is transparent black") {
    Look look = look_of({tens("shown", {"image", Input::From::source, "", 0, {}})});
    Executor executor = executor_of(look);
    run(executor, {bypassed});
    executor.draw(frame(1));
    CHECK(pixel(executor, 0) == Rgba{0, 0, 0, 0});
}

TEST_CASE_FIXTURE(Headless, "a frozen pass keeps its picture, also in its history") {
    Executor executor =
        executor_of(look_of({numbered("number"), tens("now", reads("image", "number")),
                             tens("late", reads("image", "number", 2))}));
    for (int n = 1; n <= 4; ++n)
        executor.draw(frame(n));
    CHECK(red(executor, 2) == 20.0f);
    run(executor, {frozen, drawn, drawn});
    const float late[] = {30, 40, 40, 40};
    for (int n = 5; n <= 8; ++n) {
        executor.draw(frame(n));
        CHECK(red(executor, 0) == 4.0f);
        CHECK(red(executor, 1) == 40.0f);
        CHECK(red(executor, 2) == late[n - 5]);
    }
    CHECK(executor.drawer().draw_calls() == 2);
    CHECK(executor.drawer().pass_milliseconds()[0] == 0.0);
    executor.redraw(frame(8), {true, true, true});
    CHECK(red(executor, 0) == 4.0f);
    run(executor, {});
    executor.draw(frame(9));
    CHECK(red(executor, 0) == 9.0f);
    CHECK(red(executor, 2) == 40.0f);
}

TEST_CASE_FIXTURE(Headless, "a pass with feedback continues from its frozen state") {
    Executor executor = executor_of(look_of({counter()}));
    for (int n = 1; n <= 3; ++n)
        executor.draw(frame(n));
    run(executor, {frozen});
    for (int n = 4; n <= 7; ++n)
        executor.draw(frame(n));
    CHECK(red(executor, 0) == 3.0f);
    run(executor, {});
    executor.draw(frame(8));
    CHECK(red(executor, 0) == 4.0f);
}

TEST_CASE_FIXTURE(Headless, "a frozen picture survives a restart, and an empty one is drawn once") {
    Executor executor = executor_of(look_of({numbered("number"), counter()}));
    run(executor, {frozen, drawn});
    executor.draw(frame(5));
    executor.draw(frame(6));
    CHECK(red(executor, 0) == 5.0f);
    executor.clear_history();
    executor.draw(frame(7));
    CHECK(red(executor, 0) == 5.0f);
    CHECK(red(executor, 1) == 1.0f);
    executor.clear_history(0);
    executor.draw(frame(8));
    executor.draw(frame(9));
    CHECK(red(executor, 0) == 8.0f);
    REQUIRE(executor.resize({8, 8}, {}).has_value());
    executor.draw(frame(10));
    CHECK(red(executor, 0) == 10.0f);
}

TEST_CASE_FIXTURE(Headless, "left-out passes are not drawn, and are cleared with history") {
    Executor executor = executor_of(look_of({numbered("number"), counter()}));
    executor.draw(frame(3));
    executor.draw(frame(4));
    run(executor, {drawn, left_out});
    executor.draw(frame(5));
    CHECK(red(executor, 0) == 5.0f);
    CHECK(red(executor, 1) == 2.0f);
    CHECK(executor.drawer().draw_calls() == 1);
    executor.clear_history();
    executor.draw(frame(6));
    CHECK(red(executor, 1) == 0.0f);
    run(executor, {});
    executor.draw(frame(7));
    CHECK(red(executor, 1) == 1.0f);
}

TEST_CASE_FIXTURE(Headless, "the history of one pass can be cleared alone") {
    Pass other = counter();
    other.name = "other";
    other.inputs = {reads("previous", "other", 1)};
    Executor executor = executor_of(look_of({counter(), other}));
    for (int n = 1; n <= 5; ++n)
        executor.draw(frame(n));
    const auto number = executor.textures().number();
    executor.clear_history(1);
    CHECK(executor.textures().number() != number);
    executor.redraw(frame(5), {false, true});
    CHECK(red(executor, 0) == 5.0f);
    CHECK(red(executor, 1) == 1.0f);
}

TEST_CASE_FIXTURE(Headless,
                  "a frozen accumulating pass takes no samples, and counts as converged") {
    Pass sum = counter();
    sum.accumulate = true;
    Executor executor = executor_of(look_of({sum}));
    executor.draw(frame(1));
    executor.draw(frame(2));
    CHECK_FALSE(executor.drawer().has_converged());
    run(executor, {frozen});
    executor.draw(frame(3));
    CHECK(red(executor, 0) == 2.0f);
    CHECK(executor.drawer().has_converged());
    run(executor, {});
    executor.draw(frame(4));
    CHECK_FALSE(executor.drawer().has_converged());
    CHECK(executor.drawer().samples()->held == 1);
}
