#include "byte_map.h"
#include "gpu/headless.h"
#include "gpu/objects/canvas.h"
#include "gpu/objects/draw.h"
#include "gpu/objects/readback.h"
#include "gpu/objects/vertex_array.h"
#include "gpu/program.h"

namespace {
const Stage corner{"v.vert",
                   "#version 410 core\nvoid main() { gl_Position = vec4(vec2((gl_VertexID << 1) & "
                   "2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0); }\n",
                   {}};

Stage of_light(const std::string& light) {
    return {"light.frag",
            "#version 410 core\nuniform float gain = 0.5;\nout vec4 color;\n"
            "void main() { color = vec4(" +
                light + " * gain); }\n",
            {}};
}

float drawn_by(const gpu::Program& program) {
    auto canvas = gpu::Canvas::make({2, 2}, Format::rgba32f);
    REQUIRE(canvas.has_value());
    const gpu::DrawScope scope;
    const gpu::VertexArray vertices;
    canvas->bind();
    program.use();
    vertices.bind();
    gpu::draw_triangle();
    return gpu::read_pixel(canvas->texture(), 1, 1)[0];
}

gpu::Program built(ByteStore& store, const std::string& light) {
    auto program = gpu::Program::build(corner, of_light(light), &store);
    REQUIRE(program.has_value());
    return std::move(*program);
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a program is compiled once, and later loaded from its binary") {
    ByteMap store;
    const gpu::Program first = built(store, "3.0");
    CHECK_FALSE(first.is_restored());
    REQUIRE(store.answers.size() == 1);
    first.write("gain", std::vector<double>{9.0});  // a restored program has its own default

    const gpu::Program second = built(store, "3.0");
    CHECK(second.is_restored());
    REQUIRE(second.find_uniform("gain"));
    CHECK(second.find_uniform("gain")->number == NumberType{Scalar::floating, 1, 1});
    CHECK(drawn_by(second) == 1.5f);
    CHECK_FALSE(built(store, "4.0").is_restored());
    CHECK(store.answers.size() == 2);
}

TEST_CASE_FIXTURE(Headless, "a binary of another driver is not used") {
    ByteMap store;
    static_cast<void>(built(store, "3.0"));
    const std::string key = store.answers.begin()->first;
    const gpu::DriverInfo info = gpu::read_info();
    for (const std::string& fact : {info.renderer, info.vendor, info.version})
        CHECK(key.find(fact) != std::string::npos);
    ByteMap of_other;
    const std::size_t at = key.find(info.version);
    of_other.answers[std::string(key).replace(at, info.version.size(), "4.1 other")] =
        store.answers.begin()->second;
    CHECK_FALSE(built(of_other, "3.0").is_restored());
}

TEST_CASE_FIXTURE(Headless, "an invalid binary is rejected, recompiled and replaced") {
    ByteMap store;
    static_cast<void>(built(store, "3.0"));
    std::string& answer = store.answers.begin()->second;
    const std::string good = answer;
    std::string foreign = good;  // of a format that the driver does not know
    foreign[0] = static_cast<char>(~foreign[0]);
    for (const std::string& bad : {std::string(), good.substr(0, 20), good + "!", foreign}) {
        answer = bad;
        const gpu::Program program = built(store, "3.0");
        CHECK_FALSE(program.is_restored());
        CHECK(drawn_by(program) == 1.5f);
        CHECK(answer == good);
    }
}

TEST_CASE_FIXTURE(Headless, "a compile error is reported each time and is not cached") {
    ByteMap store;
    for (int i = 0; i < 2; ++i)
        CHECK_FALSE(gpu::Program::build(corner, of_light("oops"), &store).has_value());
    CHECK(store.answers.empty());
}
