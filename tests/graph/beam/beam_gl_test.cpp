#include "graph/looks.h"

#include <numeric>

namespace {
Pass points() {
    Pass made = pass("beam", "");
    made.draw = Draw::points;
    made.blend = Blend::add;
    made.vertex = {"beam.vert",
                   "#version 410 core\nin vec2 position;\nin float intensity;\n"
                   "in float age_seconds;\nout vec2 light;\n"
                   "void main() { light = vec2(intensity, age_seconds);\n"
                   "gl_PointSize = 1.0; gl_Position = vec4(position, 0, 1); }\n",
                   {}};
    made.fragment = {"beam.frag",
                     "#version 410 core\nin vec2 light;\nout vec4 color;\n"
                     "void main() { color = vec4(light, 0, 1); }\n",
                     {}};
    return made;
}

// Each segment is a band with the height of one texel, from its start to its end.
Pass segments() {
    Pass made = pass("beam", "");
    made.draw = Draw::segments;
    made.blend = Blend::add;
    made.vertex = {
        "beam.vert",
        "#version 410 core\nin vec4 segment;\nin vec2 intensities;\nin vec2 ages_seconds;\n"
        "out vec4 light;\nvoid main() {\n"
        "bool end = (gl_VertexID & 1) == 1;\n"
        "float side = gl_VertexID < 2 ? -0.25 : 0.25;\n"
        "light = vec4(intensities, ages_seconds);\n"
        "gl_Position = vec4((end ? segment.zw : segment.xy) + vec2(0, side), 0, 1); }\n",
        {}};
    made.fragment = {"beam.frag",
                     "#version 410 core\nin vec4 light;\nout vec4 color;\n"
                     "void main() { color = light; }\n",
                     {}};
    return made;
}

// The centre of texel (x, y) of 8 x 4 in the beam's -1..1; y counts from the top.
BeamPoint at(int x, int y, float intensity = 1.0f, float age = 0.0f) {
    return {(static_cast<float>(x) + 0.5f) / 4.0f - 1.0f,
            1.0f - (static_cast<float>(y) + 0.5f) / 2.0f, intensity, age};
}

Frame with(const Beam& beam, int number) {
    Frame made = frame(number);
    made.beam = beam;
    return made;
}

float sum(const Picture& picture) {
    return std::accumulate(picture.pixels.begin(), picture.pixels.end(), 0.0f);
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a point lights the texel that contains it, with intensity and age") {
    Executor executor = executor_of(look_of({points()}), {8, 4});
    const Beam beam{at(0, 0, 2.0f, 0.5f), at(7, 3, 3.0f, 0.25f), at(7, 3, 1.0f, 0.25f)};
    executor.draw(with(beam, 1));
    CHECK(pixel(executor, 0, 0, 0) == Rgba{2, 0.5f, 0, 1});
    CHECK(pixel(executor, 0, 7, 3) == Rgba{4, 0.5f, 0, 2});
    CHECK(sum(gpu::read_picture(executor.target(0))) == 2 + 0.5f + 1 + 4 + 0.5f + 2);
}

TEST_CASE_FIXTURE(Headless, "each frame's points start on black, and an empty beam is valid") {
    Executor executor = executor_of(look_of({points()}), {8, 4});
    const Beam beam{at(3, 1)};
    executor.draw(with(beam, 1));
    executor.draw(with({}, 2));
    CHECK(sum(gpu::read_picture(executor.target(0))) == 0.0f);
    const Beam many(100000, at(2, 2));
    executor.draw(with(many, 3));
    CHECK(red(executor, 0, 2, 2) == 100000.0f);
}

TEST_CASE_FIXTURE(Headless, "segments connect consecutive points") {
    Executor executor = executor_of(look_of({segments()}), {8, 4});
    const Beam beam{at(1, 1, 2.0f, 0.5f), at(5, 1, 2.0f, 0.5f)};
    executor.draw(with(beam, 1));
    CHECK(pixel(executor, 0, 2, 1) == Rgba{2, 2, 0.5f, 0.5f});
    CHECK(pixel(executor, 0, 4, 1) == Rgba{2, 2, 0.5f, 0.5f});
    CHECK(red(executor, 0, 6, 1) == 0.0f);
    CHECK(red(executor, 0, 3, 2) == 0.0f);
    CHECK(executor.drawer().draw_calls() == 1);
}

TEST_CASE_FIXTURE(
    Headless,
    "the first point of a frame is connected to the last one of the previous frame, aged") {
    Executor executor = executor_of(look_of({segments()}), {8, 4});
    const Beam one{at(0, 0, 1.0f), at(1, 0, 1.0f, 0.5f)};
    const Beam two{at(6, 0, 1.0f, 0.25f)};
    executor.draw(with(one, 1));
    Frame second = with(two, 2);
    second.time_delta = 2.0;
    executor.draw(second);
    for (int i = 0; i < 2; ++i) {
        // At the middle the age is between 0.5 + 2 and 0.25; the attributes are those of the whole
        // segment.
        CHECK(pixel(executor, 0, 4, 0) == Rgba{1, 1, 2.5f, 0.25f});
        CHECK(red(executor, 0, 0, 0) == 0.0f);
        executor.redraw(second, {true});  // the same segment again
    }
    Frame third = with({}, 3);
    third.time_delta = 1.0;
    executor.draw(third);  // a frame without a beam
    const Beam four{at(6, 3, 1.0f, 0.0f), at(0, 3, 1.0f, 0.0f)};
    executor.draw(with(four, 1));  // a first frame has no previous point
    CHECK(red(executor, 0, 6, 1) == 0.0f);
    CHECK(red(executor, 0, 3, 3) == 1.0f);
}

namespace {
// The same pass, coloured by the beam's tint.
Pass tinted(Pass made) {
    std::string& vertex = made.vertex.text.own();
    vertex.insert(vertex.find("in float intensity") != std::string::npos
                      ? vertex.find("in float intensity")
                      : vertex.find("in vec2 intensities"),
                  "in vec3 tint;\nout vec3 shade;\n");
    vertex.insert(vertex.find("light = "), "shade = tint;\n");
    made.fragment.text =
        "#version 410 core\nin vec3 shade;\nout vec4 color;\n"
        "void main() { color = vec4(shade, 1); }\n";
    return made;
}

Frame colored(const Beam& beam, int number) {
    Frame made = with(beam, number);
    made.tints = beam.tints;
    return made;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "points have colours, and are white in a frame without tints") {
    Executor executor = executor_of(look_of({tinted(points())}), {8, 4});
    Beam beam{at(1, 1), at(5, 2)};
    beam.tints = {{0.5f, 0.25f, 0.0f}, {0.0f, 0.75f, 1.0f}};
    executor.draw(colored(beam, 1));
    CHECK(pixel(executor, 0, 1, 1) == Rgba{0.5f, 0.25f, 0, 1});
    CHECK(pixel(executor, 0, 5, 2) == Rgba{0, 0.75f, 1, 1});
    executor.draw(with(beam, 2));
    CHECK(pixel(executor, 0, 5, 2) == Rgba{1, 1, 1, 1});
}

TEST_CASE_FIXTURE(Headless, "a segment has the colour of its end point") {
    Executor executor = executor_of(look_of({tinted(segments())}), {8, 4});
    Beam beam{at(1, 1), at(5, 1), at(1, 2, 0.0f), at(5, 2)};  // the way back is blanked
    beam.tints = {{1.0f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.5f}};
    executor.draw(colored(beam, 1));
    CHECK(pixel(executor, 0, 3, 1) == Rgba{0, 0.5f, 0, 1});
    CHECK(pixel(executor, 0, 3, 2) == Rgba{0, 0, 0.5f, 1});
    CHECK(executor.drawer().draw_calls() == 1);
}
