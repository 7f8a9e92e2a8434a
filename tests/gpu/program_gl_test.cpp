#include "gpu/headless.h"
#include "gpu/program.h"

namespace {
Stage vertex() {
    return {"v.vert",
            "#version 410 core\nout vec2 uv;\nvoid main() { uv = vec2(gl_VertexID);\n"
            "gl_Position = vec4(0); }\n",
            {}};
}

Stage fragment(const std::string& body) {
    Stage stage{"glow.frag", "#version 410 core\nin vec2 uv;\nout vec4 color;\n" + body, {}};
    for (int line = 1; line <= 20; ++line)
        stage.lines.push_back(line < 4 ? Location{"glow.frag", line}
                                       : Location{"include/light.glsl", line + 96});
    return stage;
}
}  // namespace

TEST_CASE_FIXTURE(Headless, "a driver error is mapped to the original file and line") {
    const auto program =
        gpu::Program::build(vertex(), fragment("void main() {\n color = vec4(lihgt);\n}\n"));
    REQUIRE_FALSE(program.has_value());
    CHECK(program.error().front().file == "include/light.glsl");
    CHECK(program.error().front().line == 101);
    CHECK(program.error().front().message.find("lihgt") != std::string::npos);
}

TEST_CASE_FIXTURE(Headless, "errors of both stages are reported at once") {
    Stage broken = vertex();
    broken.text = "#version 410 core\nvoid main() { gl_Position = nothing; }\n";
    const auto program = gpu::Program::build(broken, fragment("void main() { color = x; }\n"));
    REQUIRE_FALSE(program.has_value());
    CHECK(program.error().front().file == "v.vert");
    CHECK(program.error().front().line == 2);
    CHECK(program.error().back().file == "include/light.glsl");
}

TEST_CASE_FIXTURE(Headless, "mismatched stages give an error in the fragment stage's file") {
    const Stage wider{"glow.frag",
                      "#version 410 core\nin vec3 uv;\nout vec4 color;\n"
                      "void main() { color = vec4(uv, 1.0); }\n",
                      {}};
    const auto program = gpu::Program::build(vertex(), wider);
    REQUIRE_FALSE(program.has_value());
    CHECK(program.error().front().file == "glow.frag");
    CHECK(program.error().front().message.find("uv") != std::string::npos);
}

TEST_CASE_FIXTURE(Headless, "an empty text or invalid GLSL is an error") {
    for (const char* text : {"", "\x01\x02\xff", "hello", "#version 999\n"}) {
        const auto program = gpu::Program::build(vertex(), {"bad.frag", text, {}});
        REQUIRE_FALSE(program.has_value());
        CHECK(has_errors(program.error()));
    }
}

TEST_CASE_FIXTURE(Headless, "a program lists its active uniforms with types") {
    const auto program = gpu::Program::build(
        vertex(), fragment("uniform vec3 tint; uniform mat2x3 turn; uniform uint bits;\n"
                           "uniform float taps[5]; uniform sampler2D image; uniform float unused;\n"
                           "void main() { color = texture(image, uv) + vec4(tint + turn * uv, "
                           "float(bits) + taps[4]); }\n"));
    REQUIRE(program.has_value());
    REQUIRE(program->find_uniform("tint"));
    CHECK(program->find_uniform("tint")->number == NumberType{Scalar::floating, 3, 1});
    REQUIRE(program->find_uniform("turn"));
    CHECK(program->find_uniform("turn")->number == NumberType{Scalar::floating, 3, 2});
    REQUIRE(program->find_uniform("bits"));
    CHECK(program->find_uniform("bits")->number == NumberType{Scalar::unsigned_integer, 1, 1});
    REQUIRE(program->find_uniform("taps"));
    CHECK(program->find_uniform("taps")->count == 5);
    REQUIRE(program->find_uniform("image"));
    CHECK(program->find_uniform("image")->sampled == gpu::Uniform::Sampled::floating);
    CHECK(program->find_uniform("unused") == nullptr);
}

TEST_CASE_FIXTURE(Headless, "writing unknown uniforms or a wrong number of values is harmless") {
    const auto program = gpu::Program::build(
        vertex(), fragment("uniform vec3 tint; uniform int count; uniform float taps[2];\n"
                           "void main() { color = vec4(tint, float(count) + taps[1]); }\n"));
    REQUIRE(program.has_value());
    program->write("absent", std::vector<double>{1});
    program->write("tint", std::vector<double>{1, 2});
    program->write("tint", std::vector<double>{});
    program->write("count", std::vector<double>{1e300});
    program->write("taps", std::vector<double>(5000, 1.0));
}
