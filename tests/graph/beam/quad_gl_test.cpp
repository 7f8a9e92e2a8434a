// Passes as in foreign chains: a quad with its own vertex shader, rows from the top, uniforms with
// other names.
#include "graph/looks.h"

namespace {
constexpr const char* quad_vertex = R"(#version 410 core
uniform mat4 MVP;
layout(location = 0) in vec4 position;
layout(location = 1) in vec2 coordinate;
layout(location = 0) out vec2 there;
void main() {
    gl_Position = MVP * position;
    there = coordinate;
}
)";

Pass quad_pass(const std::string& name, const std::string& body, std::vector<Input> inputs,
               RowOrder rows) {
    Pass made = pass(name, "", std::move(inputs));
    made.draw = Draw::quad;
    made.vertex = {"test.vert", quad_vertex, {{"test.vert", 1}}};
    made.fragment.text =
        "#version 410 core\nlayout(location = 0) in vec2 there;\nout vec4 color;\n" + body;
    made.built_ins = {{"MVP", BuiltIn::quad_to_clip}};
    made.rows = rows;
    return made;
}

const std::string copying =
    "uniform sampler2D image;\nvoid main() { color = texture(image, there); }\n";
// Red: the row of the target, counted from GL's first row.
const std::string row_counting =
    "void main() { color = vec4(floor(gl_FragCoord.y), there.y, 0, 1); }\n";

Input of_source(const std::string& uniform) {
    return {uniform, Input::From::source, "", 0, {Filter::nearest, Wrap::edge, false}};
}

Picture numbered(Extent extent) {
    Picture picture{extent, 4, Encoding::display, {}};
    for (int i = 0; i < extent.width * extent.height; ++i)
        for (const float number : {static_cast<float>(i), 0.0f, 0.5f, 1.0f})
            picture.pixels.push_back(number);
    return picture;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a chain with rows from the top shows the source upright") {
    Look look =
        look_of({quad_pass("first", copying, {of_source("image")}, RowOrder::top_first),
                 quad_pass("last", copying, {reads("image", "first")}, RowOrder::bottom_first)});
    look.source_rows = RowOrder::top_first;
    look.source_encoding = Encoding::display;
    Executor executor = executor_of(look, {3, 2}, {3, 2});
    const Picture source = numbered({3, 2});
    REQUIRE(executor.set_source(source));
    executor.draw(frame(1));
    CHECK(gpu::read_picture(executor.target(1)).pixels == source.pixels);
    CHECK(gpu::read_picture(executor.target(0)).pixels == source.pixels);  // flipped when read
    CHECK(gpu::read_picture(*executor.texture({Input::From::source, {}})).pixels == source.pixels);
}

TEST_CASE_FIXTURE(Headless,
                  "the readable copy of a target with its top row first is updated each frame") {
    Pass counting =
        quad_pass("counting", "uniform int count;\nvoid main() { color = vec4(count); }\n", {},
                  RowOrder::top_first);
    counting.built_ins.push_back({"count", BuiltIn::frame_index});
    counting.frame_modulo = 3;
    Executor executor = executor_of(look_of({counting}), {1, 1});
    for (const float expected : {0.0f, 1.0f, 2.0f, 0.0f, 1.0f}) {
        static int number = 0;
        executor.draw(frame(++number));
        CHECK(gpu::read_picture(executor.target(0)).pixels.front() == expected);
    }
}

TEST_CASE_FIXTURE(Headless, "gl_FragCoord counts from the first row, at the top or at the bottom") {
    for (const RowOrder rows : {RowOrder::top_first, RowOrder::bottom_first}) {
        Executor executor =
            executor_of(look_of({quad_pass("rows", row_counting, {}, rows)}), {1, 4});
        executor.draw(frame(1));
        const Picture drawn = gpu::read_picture(executor.target(0));
        for (int y = 0; y < 4; ++y) {
            const float* pixel = drawn.pixels.data() + drawn.index(0, y);
            CHECK(pixel[0] == static_cast<float>(rows == RowOrder::top_first ? y : 3 - y));
            CHECK(pixel[1] == doctest::Approx((y + 0.5) / 4.0));  // v goes down in both
        }
    }
}

TEST_CASE_FIXTURE(Headless, "extents of all inputs include their reciprocals") {
    Pass half = pass("half", "void main() { color = vec4(1.0); }\n");
    half.size.fill({Side::By::viewport, 0.5, {}});
    Pass told =
        pass("told",
             "uniform vec4 own, all, read, given;\nuniform float aspect;\nuniform uint gone;\n"
             "void main() { color = own + all + read + given + aspect + float(gone); }\n");
    told.size.fill({Side::By::before, 0.25, {}});
    told.built_ins = {{"own", BuiltIn::target_extent},
                      {"all", BuiltIn::output_extent},
                      {"read", BuiltIn::input_extent, reads("", "half")},
                      {"given", BuiltIn::input_extent, of_source("")},
                      {"aspect", BuiltIn::source_aspect},
                      {"gone", BuiltIn::microseconds}};
    Executor executor = executor_of(look_of({half, told}), {32, 16}, {10, 5});
    Frame now = frame(1);
    now.time_delta = 1.0 / 60.0;
    executor.draw(now);
    const auto numbers = [&](const std::string& name) {
        for (const BuiltInReport& report : executor.drawer().report(1).built_ins)
            if (report.name == name)
                return report.numbers;
        return std::vector<double>{};
    };
    CHECK(numbers("own") == std::vector{4.0, 2.0, 0.25, 0.5});
    CHECK(numbers("all") == std::vector{32.0, 16.0, 1.0 / 32.0, 1.0 / 16.0});
    CHECK(numbers("read") == std::vector{16.0, 8.0, 1.0 / 16.0, 1.0 / 8.0});
    CHECK(numbers("given") == std::vector{10.0, 5.0, 0.1, 0.2});
    CHECK(numbers("aspect") == std::vector{2.0});
    CHECK(numbers("gone") == std::vector{16667.0});
}
