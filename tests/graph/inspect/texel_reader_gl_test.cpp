#include "gpu/objects/draw.h"
#include "graph/inspect/level_copy.h"
#include "graph/inspect/texel_reader.h"
#include "graph/looks.h"

namespace {
using Rows = std::vector<Rgba>;

// Red is the column from the left, green the row from the top of five.
const char* const places_body =
    "void main() { color = vec4(floor(gl_FragCoord.x), 4.0 - floor(gl_FragCoord.y), 0.5, 1.0); }\n";

Rows read(const gpu::Texture& texture, const TexelRows& rows) {
    auto reader = TexelReader::make();
    REQUIRE(reader.has_value());
    TexelReadback answer;
    answer.ask(*reader, texture, rows);
    CHECK(answer.is_busy());
    gpu::finish();
    auto numbers = answer.take();
    REQUIRE(numbers.has_value());
    CHECK_FALSE(answer.is_busy());
    return *numbers;
}

Rgba place(float x, float y) {
    return {x, y, 0.5f, 1.0f};
}

Pass coded(const char* name, Format format, const char* type, const char* value) {
    Pass made = pass(name, "");
    made.format = format;
    made.fragment = {"test.frag",
                     std::string("#version 410 core\nout ") + type +
                         " color;\nvoid main() { color = " + value + "; }\n",
                     {}};
    return made;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "texels are read row by row from the top left, or along a line") {
    Executor executor = executor_of(look_of({pass("places", places_body)}), {8, 5});
    executor.draw(frame(1));
    const gpu::Texture& texture = executor.target(0);
    CHECK(read(texture, {.count = {2, 3}, .first = {5, 1}}) ==
          Rows{place(5, 1), place(6, 1), place(5, 2), place(6, 2), place(5, 3), place(6, 3)});
    CHECK(read(texture, {.count = {4, 1}, .first = {2.5, 3.5}, .across = {2, -1}}) ==
          Rows{place(2, 3), place(4, 2), place(6, 1), place(7, 0)});  // clamped to the edge
}

TEST_CASE_FIXTURE(Headless, "texels of every type of target are read as stored") {
    Executor executor =
        executor_of(look_of({coded("whole", Format::r32ui, "uvec4", "uvec4(70000u)"),
                             coded("lone", Format::r16f, "vec4", "vec4(65504.0)"),
                             coded("clear", Format::rgba16f, "vec4", "vec4(-3.0, 0.0, 1e-4, 0.25)"),
                             coded("bytes", Format::rgba8, "vec4", "vec4(51.0 / 255.0)")}));
    executor.draw(frame(1));
    const auto first = [&](int pass) { return read(executor.target(pass), {.count = {1, 1}})[0]; };
    CHECK(first(0)[0] == 70000.0f);
    CHECK(first(1) == Rgba{65504, 0, 0, 1});
    CHECK(first(2)[0] == -3.0f);
    CHECK(std::abs(first(2)[2] - 1e-4f) <= 1e-7f);  // a half float has 11 bits
    CHECK(first(2)[3] == 0.25f);
    CHECK(std::abs(first(3)[0] - 0.2f) <= 1e-6f);
}

TEST_CASE_FIXTURE(Headless,
                  "a mipmap level is read as a picture: the mean of the texels that it covers") {
    const char* const halves = "void main() { color = vec4(floor(uv.x * 2.0) * 8.0, 0, 0, 1); }\n";
    Look look = look_of({pass("halves", halves),
                         pass("small",
                              "uniform sampler2D image;\nvoid main() { color = textureLod(image, "
                              "uv, 1.0); }\n",
                              {reads("image", "halves", 0, {Filter::linear, Wrap::edge, true})})});
    look.passes[0].format = Format::r16f;
    Executor executor = executor_of(look, {8, 4});
    executor.draw(frame(1));
    auto copy = LevelCopy::make();
    REQUIRE(copy.has_value());
    CHECK(level_count(executor.target(0)) == 4);  // 8, 4, 2, 1 wide
    CHECK(level_count(executor.target(1)) == 1);
    const gpu::Texture* second = copy->draw(executor.target(0), 1);
    REQUIRE(second);
    CHECK(second->extent() == Extent{4, 2});
    CHECK(second->format() == Format::r16f);
    CHECK(gpu::read_pixel(*second, 1, 0)[0] == 0.0f);
    CHECK(gpu::read_pixel(*second, 2, 1)[0] == 8.0f);
    const gpu::Texture* last = copy->draw(executor.target(0), 3);
    REQUIRE(last);
    CHECK(last->extent() == Extent{1, 1});
    CHECK(gpu::read_pixel(*last, 0, 0)[0] == 4.0f);
    CHECK(copy->draw(executor.target(0), 4) == nullptr);
    CHECK(copy->draw(executor.target(1), 1) == nullptr);
}
