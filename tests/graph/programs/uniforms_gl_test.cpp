#include "graph/looks.h"

#include <fmt/format.h>

namespace {
// Draws `expression` of one uniform with the given GLSL type.
Rgba shown(const std::string& type, const std::string& expression, NumberType number, Value initial,
           const Values& values) {
    Executor executor = executor_of(look_of(
        {pass("show", "uniform " + type + " k;\nvoid main() { color = " + expression + "; }\n")},
        {parameter_named("k", number, std::move(initial), {{0, "k"}})}));
    executor.set_values(values);
    executor.draw(frame(1));
    return pixel(executor, 0);
}

Value count_to(int size) {
    std::vector<double> numbers;
    for (int i = 1; i <= size; ++i)
        numbers.push_back(i);
    return Value(numbers);
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a value is set for every scalar and vector type") {
    for (int rows = 1; rows <= 4; ++rows)
        for (const Scalar scalar : {Scalar::floating, Scalar::integer, Scalar::unsigned_integer}) {
            const NumberType type{scalar, rows, 1};
            CAPTURE(glsl_name(type));
            std::string components = "vec4(";
            for (int i = 0; i < 4; ++i)
                components += (i ? ", " : "") + std::string(i < rows ? "float(k" : "0.0") +
                              (i < rows ? (rows > 1 ? "[" + std::to_string(i) + "])" : ")") : "");
            Rgba wanted{};
            for (int i = 0; i < rows; ++i)
                wanted[static_cast<std::size_t>(i)] = static_cast<float>(i + 1);
            CHECK(shown(glsl_name(type), components + ")", type, count_to(rows), {}) == wanted);
        }
}

TEST_CASE_FIXTURE(Headless, "booleans are 0 or 1") {
    const NumberType one{Scalar::boolean, 1, 1};
    const NumberType three{Scalar::boolean, 3, 1};
    CHECK(shown("bool", "vec4(k)", one, 0.0, {{"k", 1.0}})[0] == 1.0f);
    CHECK(shown("bool", "vec4(k)", one, 1.0, {{"k", 0.0}})[0] == 0.0f);
    CHECK(shown("bvec3", "vec4(k, 0)", three, Value({0, 0, 0}), {{"k", Value({1, 0, 1})}}) ==
          Rgba{1, 0, 1, 0});
}

TEST_CASE_FIXTURE(Headless, "matrices are filled by columns, square or not") {
    for (int columns = 2; columns <= 4; ++columns)
        for (int rows = 2; rows <= 4; ++rows) {
            const NumberType type{Scalar::floating, rows, columns};
            CAPTURE(glsl_name(type));
            // The first and last row of the last column: (columns-1)*rows + 1 and columns*rows.
            const std::string ends =
                fmt::format("vec4(k[{0}][0], k[{0}][{1}], k[0][1], 0)", columns - 1, rows - 1);
            const Rgba drawn = shown(glsl_name(type), ends, type, count_to(rows * columns), {});
            CHECK(drawn == Rgba{static_cast<float>((columns - 1) * rows + 1),
                                static_cast<float>(columns * rows), 2, 0});
        }
}

TEST_CASE_FIXTURE(Headless, "large integers are exact, and unsuitable values are converted") {
    const NumberType unsigned_integer{Scalar::unsigned_integer, 1, 1};
    CHECK(shown("uint", "vec4(k >> 16u, k & 0xffffu, 0, 0)", unsigned_integer, 0.0,
                {{"k", 4294967295.0}}) == Rgba{65535, 65535, 0, 0});
    CHECK(shown("vec2", "vec4(k, 0, 0)", {Scalar::floating, 2, 1}, Value({3, 4}),
                {{"k", Value(std::vector<double>{9})}}) == Rgba{9, 4, 0, 0});
    CHECK(shown("float", "vec4(k)", {}, 2.0, {{"k", Value::of_path("x.png")}})[0] == 2.0f);
}

TEST_CASE_FIXTURE(
    Headless, "one parameter sets several passes, and a renamed uniform has its own parameter") {
    const std::string body = "uniform float amount;\nvoid main() { color = vec4(amount); }\n";
    const Look look = look_of({pass("a", body), pass("b", body), pass("c", body)},
                              {parameter_named("amount", {}, 1.0, {{0, "amount"}, {1, "amount"}}),
                               parameter_named("amount_c", {}, 2.0, {{2, "amount"}})});
    Executor executor = executor_of(look);
    executor.set_values({{"amount", 5.0}});
    executor.draw(frame(1));
    CHECK(red(executor, 0) == 5.0f);
    CHECK(red(executor, 1) == 5.0f);
    CHECK(red(executor, 2) == 2.0f);
    executor.set_values({{"amount_c", 8.0}});  // the other one returns to its default
    executor.draw(frame(2));
    CHECK(red(executor, 0) == 1.0f);
    CHECK(red(executor, 2) == 8.0f);
}

TEST_CASE_FIXTURE(Headless, "`set` fixes a uniform in one pass, also if two passes share a text") {
    const std::string body = "uniform vec2 way;\nvoid main() { color = vec4(way, 0, 0); }\n";
    Look look = look_of({pass("x", body), pass("y", body)});
    look.passes[0].set = {{"way", Value({1, 0})}};
    look.passes[1].set = {{"way", Value({0, 1})}, {"absent", 3.0}};
    Executor executor = executor_of(look);
    executor.draw(frame(1));
    CHECK(pixel(executor, 0) == Rgba{1, 0, 0, 0});
    CHECK(pixel(executor, 1) == Rgba{0, 1, 0, 0});

    look.passes[0].set.clear();  // back to GLSL's own default
    REQUIRE(executor.replace(look, programs_of(look, &executor.programs().generic())).has_value());
    executor.draw(frame(2));
    CHECK(pixel(executor, 0) == Rgba{0, 0, 0, 0});
    CHECK(pixel(executor, 1) == Rgba{0, 1, 0, 0});
}

TEST_CASE_FIXTURE(Headless, "values survive an edit of the look") {
    const Look look = look_of({pass("a", "uniform float k;\nvoid main() { color = vec4(k); }\n")},
                              {parameter_named("k", {}, 1.0, {{0, "k"}})});
    Executor executor = executor_of(look);
    executor.set_values({{"k", 6.0}});
    Look edited = look;
    edited.passes[0].fragment =
        fragment("uniform float k;\nvoid main() { color = vec4(k * 2.0); }\n");
    REQUIRE(executor.replace(edited, programs_of(edited)).has_value());
    executor.draw(frame(1));
    CHECK(red(executor, 0) == 12.0f);
}

TEST_CASE_FIXTURE(Headless, "built-in uniforms are set: time, frame, sizes, mouse and view") {
    Look look = look_of({pass("clock",
                              "uniform float u_time, u_time_delta; uniform int u_frame;\n"
                              "void main() { color = vec4(u_time, u_time_delta, u_frame, 0); }\n"),
                         pass("sizes",
                              "uniform vec2 u_resolution, u_output_resolution;\n"
                              "void main() { color = vec4(u_resolution, u_output_resolution); }\n"),
                         pass("others",
                              "uniform vec2 u_source_resolution, u_mouse;\n"
                              "void main() { color = vec4(u_source_resolution, u_mouse); }\n"),
                         pass("view",
                              "uniform mat4 u_view; uniform float u_frame;\n"
                              "void main() { color = u_view * vec4(1, 2, 3, u_frame); }\n")});
    look.passes[1].size.fill({Side::By::viewport, 0.5, {}});
    look.passes[3].frame_modulo = 4;
    Executor executor = executor_of(look, {8, 4}, {320, 200});
    Frame now = frame(6);
    now.mouse = {3.5, 1.5};
    executor.draw(now);
    CHECK(pixel(executor, 0) ==
          Rgba{static_cast<float>(6 / 60.0), static_cast<float>(1 / 60.0), 6, 0});
    CHECK(pixel(executor, 1) == Rgba{4, 2, 8, 4});
    CHECK(pixel(executor, 2) == Rgba{320, 200, 3.5f, 1.5f});
    CHECK(pixel(executor, 3) == Rgba{1, 2, 3, 2});
}

TEST_CASE_FIXTURE(Headless, "a pass reads the raster of its source: lines and columns") {
    const Look look = look_of({pass("lines",
                                    "uniform vec3 u_source_lines;\n"
                                    "void main() { color = vec4(u_source_lines, 0); }\n"),
                               pass("columns",
                                    "uniform vec3 u_source_columns;\n"
                                    "void main() { color = vec4(u_source_columns, 0); }\n")});
    Executor executor = executor_of(look, {8, 4}, {320, 200});
    executor.draw(frame(1));
    CHECK(pixel(executor, 0) == Rgba{0, 0.005f, 200, 0});
    CHECK(pixel(executor, 1) == Rgba{0, 0.003125f, 320, 0});
    Frame placed = frame(2);
    placed.source_raster = SourceRaster{{0.25, 1.0 / 512.0, 256}, {-0.5, 1.0 / 128.0, 256}};
    executor.draw(placed);
    CHECK(pixel(executor, 0) == Rgba{0.25f, 1.0f / 512.0f, 256, 0});
    CHECK(pixel(executor, 1) == Rgba{-0.5f, 1.0f / 128.0f, 256, 0});
}

TEST_CASE_FIXTURE(Headless, "each of hundreds of parameters sets its own uniform") {
    std::string declarations;
    std::string sum = "0.0";
    std::vector<Parameter> parameters;
    double expected = 0;
    for (int i = 0; i < 300; ++i) {
        const std::string name = "k" + std::to_string(i);
        declarations += "uniform float " + name + ";\n";
        sum += " + " + name + " * " + std::to_string(i + 1) + ".0";
        parameters.push_back(parameter_named(name, {}, i % 7, {{0, name}}));
        expected += (i == 250 ? 100 : i % 7) * (i + 1);
    }
    Executor executor = executor_of(look_of(
        {pass("sum", declarations + "void main() { color = vec4(" + sum + "); }\n")}, parameters));
    executor.set_values({{"k250", 100.0}, {"orphan", 1.0}});
    executor.draw(frame(1));
    CHECK(red(executor, 0) == static_cast<float>(expected));
}

TEST_CASE_FIXTURE(Headless, "a colour is set as linear light, or display-encoded") {
    const auto color = [](Encoding encoding) {
        Parameter tint = parameter_named("tint", {Scalar::floating, 4, 1},
                                         Value({0.21404, 1.0, 0.0, 0.25}), {{0, "tint"}});
        tint.control = Control::color;
        tint.encoding = encoding;
        Executor executor = executor_of(
            look_of({pass("show", "uniform vec4 tint;\nvoid main() { color = tint; }\n")}, {tint}));
        executor.draw(frame(1));
        return pixel(executor, 0);
    };
    CHECK(color(Encoding::linear)[0] == doctest::Approx(0.21404));
    // IEC 61966-2-1; alpha is not encoded.
    const Rgba encoded = color(Encoding::display);
    CHECK(encoded[0] == doctest::Approx(0.5).epsilon(1e-4));
    CHECK(encoded[1] == doctest::Approx(1.0));
    CHECK(encoded[3] == 0.25f);
}

TEST_CASE_FIXTURE(Headless,
                  "an event is on for one frame, until it is released and triggered again") {
    Parameter event = parameter_named("hit", {Scalar::boolean, 1, 1}, 0.0, {{0, "hit"}});
    event.control = Control::event;
    Executor executor = executor_of(look_of(
        {pass("show", "uniform bool hit;\nvoid main() { color = vec4(hit ? 1.0 : 0.0); }\n")},
        {event}));
    const auto drawn = [&](int number) {
        executor.draw(frame(number));
        return red(executor, 0);
    };
    CHECK(drawn(1) == 0.0f);
    executor.set_values({{"hit", 1.0}});
    CHECK(drawn(2) == 1.0f);
    CHECK(drawn(3) == 0.0f);
    executor.set_values({{"hit", 1.0}, {"other", 2.0}});  // still held
    Executor other(executor.look(), executor.programs().generic());
    REQUIRE(other.resize({8, 8}, {8, 8}).has_value());
    other.draw(frame(1));  // writes its own values
    CHECK(drawn(4) == 0.0f);
    executor.set_values({});
    CHECK(drawn(5) == 0.0f);
    executor.set_values({{"hit", 1.0}});
    CHECK(drawn(6) == 1.0f);
}
