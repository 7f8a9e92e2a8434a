#include "about.h"
#include "graph/looks.h"

namespace {
// Shows one input over the whole target.
Pass show(std::vector<Input> inputs, const std::string& expression = "texture(image, uv)") {
    return pass("show", "uniform sampler2D image;\nvoid main() { color = " + expression + "; }\n",
                std::move(inputs));
}

// 2 x 2: red, green over blue, white.
Picture corners() {
    return {{2, 2}, 4, Encoding::linear, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1}};
}

Input source(int frames_ago = 0, Sampler sampler = {Filter::nearest, Wrap::edge, false}) {
    return {"image", Input::From::source, "", frames_ago, sampler};
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "the source is upright: its row 0 is the top of the picture") {
    Executor executor = executor_of(look_of({show({source()})}), {2, 2}, {2, 2});
    REQUIRE(executor.set_source(corners()).has_value());
    executor.draw(frame(1));
    CHECK(gpu::read_picture(executor.target(0)) == corners());
}

TEST_CASE_FIXTURE(Headless, "uv (0,0) is the bottom left of the picture") {
    Executor executor =
        executor_of(look_of({pass("uv", "void main() { color = vec4(uv, 0, 1); }\n")}));
    executor.draw(frame(1));
    CHECK(pixel(executor, 0, 0, 3) == Rgba{0.125f, 0.125f, 0, 1});
    CHECK(pixel(executor, 0, 3, 0) == Rgba{0.875f, 0.875f, 0, 1});
}

TEST_CASE_FIXTURE(Headless, "the source is converted to the encoding that the look reads") {
    Look look = look_of({show({source()})});
    Picture half{{1, 1}, 3, Encoding::display, {0.5f, 0.5f, 0.5f}};
    Executor linear = executor_of(look);
    REQUIRE(linear.set_source(half).has_value());
    linear.draw(frame(1));
    CHECK(red(linear, 0) == about(0.214041, 1e-5));  // sRGB 0.5
    look.source_encoding = Encoding::display;
    Executor display = executor_of(look);
    REQUIRE(display.set_source(half).has_value());
    display.draw(frame(1));
    CHECK(red(display, 0) == 0.5f);
    CHECK_FALSE(display.set_source(Picture{}).has_value());
}

TEST_CASE_FIXTURE(Headless, "source@n is the source of n frames ago") {
    Executor executor = executor_of(
        look_of({show({source(2)}), pass("now", show({}).fragment.text->substr(44), {source()})}));
    const float expected[] = {0, 0, 1, 2, 2, 4};
    for (int n = 1; n <= 6; ++n) {
        const auto value = static_cast<float>(n);
        if (n != 3)  // one frame without a new picture
            REQUIRE(executor.set_source({{1, 1}, 1, Encoding::linear, {value}}).has_value());
        executor.draw(frame(n));
        CHECK(red(executor, 0) == expected[n - 1]);
        CHECK(red(executor, 1) == (n == 3 ? 2.0f : value));
        executor.redraw(frame(n), {true, true});
        CHECK(red(executor, 0) == expected[n - 1]);
    }
}

TEST_CASE_FIXTURE(Headless, "an input without a source reads transparent black") {
    Look look = look_of({show({}),
                         pass("other",
                              "uniform usampler2D image;\nvoid main() { color = "
                              "vec4(texelFetch(image, ivec2(0), 0).r); }\n"),
                         pass("solid",
                              "uniform samplerCube box; uniform isampler2D whole;\nvoid main() "
                              "{ color = texture(box, vec3(uv, 1)) + "
                              "vec4(texelFetch(whole, ivec2(0), 0)); }\n")});
    look.passes[0].inputs = {{"image", Input::From::image, "lost", 0, {}}};
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    CHECK(pixel(executor, 0) == Rgba{0, 0, 0, 0});
    CHECK(pixel(executor, 1) == Rgba{0, 0, 0, 0});
}

TEST_CASE_FIXTURE(Headless,
                  "images are found by name; colours are converted for the look, and data is not") {
    Look look = look_of(
        {show({{"image", Input::From::image, "lut", 0, {}}}),
         pass("data", "uniform sampler2D d;\nvoid main() { color = texture(d, uv); }\n",
              {{"d", Input::From::image, "noise", 0, {}}}),
         pass("picked", "uniform sampler2D p;\nvoid main() { color = texture(p, uv); }\n")});
    look.images = {{"lut", "lut.png", {}, false}, {"noise", "noise.png", {}, true}};
    Parameter picker = parameter_named("choice", {}, Value::of_path("a.png"), {{2, "p"}});
    picker.control = Control::image;
    look.parameters = {picker};
    Executor executor = executor_of(look);
    const Picture half{{1, 1}, 1, Encoding::display, {0.5f}};
    for (const char* name : {"lut", "noise", "choice"})
        REQUIRE(executor.set_image(name, half).has_value());
    executor.draw(frame(1));
    CHECK(red(executor, 0) == about(0.214041, 1e-5));
    CHECK(red(executor, 1) == 0.5f);
    CHECK(red(executor, 2) == about(0.214041, 1e-5));
}

TEST_CASE_FIXTURE(Headless, "each input has its own wrap mode") {
    // One texel beyond the right edge of red, green / blue, white, in the top row.
    const auto beyond = [](Wrap wrap) {
        Executor executor = executor_of(look_of({show({source(0, {Filter::nearest, wrap, false})},
                                                      "texture(image, vec2(1.25, 0.75))")}));
        REQUIRE(executor.set_source(corners()).has_value());
        executor.draw(frame(1));
        return pixel(executor, 0);
    };
    CHECK(beyond(Wrap::edge) == Rgba{0, 1, 0, 1});
    CHECK(beyond(Wrap::border) == Rgba{0, 0, 0, 0});
    CHECK(beyond(Wrap::repeat) == Rgba{1, 0, 0, 1});
    CHECK(beyond(Wrap::mirror) == Rgba{0, 1, 0, 1});
}

TEST_CASE_FIXTURE(Headless, "one target is read with two filters in one frame") {
    const std::string middle = "texture(image, vec2(0.5, 0.75))";
    Look look =
        look_of({pass("ramp", "void main() { color = vec4(gl_FragCoord.x < 1.0 ? 0.0 : 4.0); }\n"),
                 show({reads("image", "ramp", 0, {Filter::linear, Wrap::edge, false})}, middle),
                 show({reads("image", "ramp")}, "texture(image, vec2(0.4, 0.75))")});
    look.passes[2].name = "nearest";
    Executor executor = executor_of(look, {2, 2});
    executor.draw(frame(1));
    CHECK(red(executor, 1) == 2.0f);
    CHECK(red(executor, 2) == 0.0f);
}

TEST_CASE_FIXTURE(Headless,
                  "the smallest mipmap level is the mean of the target, updated each frame") {
    Look look = look_of({pass("ramp",
                              "uniform int u_frame;\nvoid main() { color = "
                              "vec4(floor(gl_FragCoord.x) * u_frame); }\n"),
                         show({reads("image", "ramp", 0, {Filter::linear, Wrap::edge, true})},
                              "textureLod(image, vec2(0.5), 3.0)")});
    Executor executor = executor_of(look, {8, 8});
    for (int n = 1; n <= 2; ++n) {
        executor.draw(frame(n));
        CHECK(red(executor, 1) == doctest::Approx(3.5 * n));
    }
}

TEST_CASE_FIXTURE(Headless, "blending starts from the neutral value of its mode") {
    const auto blended = [](Blend blend, int repeats) {
        Look look = look_of({pass("a", "void main() { color = vec4(3.0, 0.5, -1.0, 0.5); }\n")});
        look.passes[0].blend = blend;
        look.passes[0].repeat = repeats;
        Executor executor = executor_of(look);
        executor.draw(frame(1));
        executor.draw(frame(2));
        return pixel(executor, 0);
    };
    CHECK(blended(Blend::replace, 2) == Rgba{3, 0.5f, -1, 0.5f});
    CHECK(blended(Blend::add, 2) == Rgba{6, 1, -2, 1});
    CHECK(blended(Blend::alpha, 2) == Rgba{2.25f, 0.375f, -0.75f, 0.75f});
    CHECK(blended(Blend::multiply, 2) == Rgba{9, 0.25f, 1, 0.25f});
    CHECK(blended(Blend::maximum, 2) == Rgba{3, 0.5f, 0, 0.5f});
}

TEST_CASE_FIXTURE(Headless, "a pass that discards leaves black, not the previous frame") {
    Executor executor = executor_of(look_of({pass(
        "a",
        "uniform int u_frame;\nvoid main() { if (u_frame > 1) discard; color = vec4(1); }\n")}));
    executor.draw(frame(1));
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 0.0f);
}

TEST_CASE_FIXTURE(Headless, "an integer target is exact, and an sRGB target encodes and decodes") {
    Look look =
        look_of({pass("count", ""),
                 pass("read",
                      "uniform usampler2D n;\nvoid main() { color = "
                      "vec4(texelFetch(n, ivec2(0), 0).r & 0xffffu); }\n",
                      {reads("n", "count")}),
                 pass("srgb", "void main() { color = vec4(0.5); }\n"),
                 pass("back", "uniform sampler2D s;\nvoid main() { color = texture(s, uv); }\n",
                      {reads("s", "srgb")})});
    look.passes[0].fragment.text =
        "#version 410 core\nin vec2 uv;\nout uint color;\n"
        "void main() { color = 0x12345678u; }\n";
    look.passes[0].format = Format::r32ui;
    look.passes[0].blend = Blend::add;  // integers do not blend
    look.passes[2].format = Format::srgb8_alpha8;
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    CHECK(red(executor, 1) == static_cast<float>(0x5678));
    CHECK(red(executor, 2) == about(0.735357, 0.005));  // sRGB of 0.5
    CHECK(red(executor, 3) == about(0.5, 0.01));
}

TEST_CASE_FIXTURE(Headless, "targets have the planned sizes, and unchanged targets are kept") {
    Look look = look_of({counter(), pass("half", "void main() { color = vec4(1); }\n")});
    look.passes[0].size.fill({Side::By::pixels, 16, {}});
    look.passes[1].size = {Side{Side::By::viewport, 0.5, {}},
                           Side{Side::By::expression, 1, "$rows"}};
    look.parameters = {parameter_named("rows", {}, 3.0, {})};
    Executor executor = executor_of(look, {100, 100});
    CHECK(executor.target(1).extent() == Extent{50, 3});
    executor.draw(frame(1));
    executor.set_values({{"rows", 7.0}});
    REQUIRE(executor.resize({80, 100}, {}).has_value());
    CHECK(executor.target(1).extent() == Extent{40, 7});
    CHECK(executor.plan().targets[1].extent == Extent{40, 7});
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 2.0f);
}

TEST_CASE_FIXTURE(Headless, "a very large target is drawn, and one beyond the limit is an error") {
    Look look = look_of({pass("large", "void main() { color = vec4(gl_FragCoord.x); }\n")});
    look.passes[0].format = Format::r8;
    Executor executor = executor_of(look, {8192, 8192});
    CHECK(executor.target(0).extent() == Extent{8192, 8192});
    const int largest = (*context)->info().largest_texture;
    const auto sized = executor.resize({largest + 1, 16}, {});
    REQUIRE_FALSE(sized.has_value());
    CHECK(
        to_string(sized.error().front()).starts_with("look.json:5: error: pass 'large' would be "));
}

TEST_CASE_FIXTURE(Headless,
                  "targets beyond the memory limit are rejected before they are created") {
    Look look = look_of({});
    for (int i = 0; i < 40; ++i)
        look.passes.push_back(pass("p" + std::to_string(i), "void main() { color = vec4(1); }\n"));
    Executor executor(look, programs_of(look));
    const auto sized = executor.resize({8192, 8192}, {});  // 40 of 1 GiB
    REQUIRE_FALSE(sized.has_value());
    CHECK(sized.error().front().message == "the targets need 40.0 GiB; the limit is 8 GiB");
}

TEST_CASE_FIXTURE(Headless,
                  "every pass is one draw call, and its time is available some frames later") {
    Executor executor = executor_of(
        look_of({counter(), pass("b", "void main() { color = vec4(1); }\n")}), {256, 256});
    CHECK(executor.drawer().pass_milliseconds() == std::vector<double>{0, 0});
    for (int n = 1; n <= 6; ++n)
        executor.draw(frame(n));
    CHECK(executor.drawer().draw_calls() == 2);
    gpu::read_picture(executor.target(1));  // waits
    for (const double time : executor.drawer().pass_milliseconds())
        CHECK(time > 0.0);
}
