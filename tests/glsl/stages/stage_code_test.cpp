#include "glsl/stages/stage_code.h"

#include <doctest/doctest.h>

namespace {
Stage stage(std::string_view text) {
    Stage stage;
    stage.text = "#version 410 core\n" + std::string(text);
    return stage;
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}
}  // namespace

TEST_CASE("a pass is written for Vulkan, Direct3D and Metal") {
    const auto code = stage_code(
        stage("out vec2 uv;\nvoid main() { uv = vec2(gl_VertexID); gl_Position = vec4(uv, 0, 1); "
              "}\n"),
        stage("in vec2 uv;\nout vec4 color;\nuniform float gain = 2.0;\nuniform bool is_on;\n"
              "uniform sampler2D picture;\n"
              "void main() { color = is_on ? texture(picture, uv) * gain : vec4(0.0); }\n"));
    REQUIRE_MESSAGE(code.has_value(), code.error().front().message);
    for (const StageCode* stage : {&code->vertex, &code->fragment}) {
        for (const auto& [language, fault] : stage->faults)
            FAIL_CHECK(language << ": " << fault);
        REQUIRE(stage->spirv.size() > 20);
        CHECK(stage->spirv.substr(0, 4) == "\x03\x02\x23\x07");  // the magic number of SPIR-V
    }
    CHECK_MESSAGE(has(code->fragment.hlsl, "SamplerState"), code->fragment.hlsl);
    CHECK_MESSAGE(has(code->fragment.msl, "#include <metal_stdlib>"), code->fragment.msl);
    CHECK_MESSAGE(has(code->fragment.reflection, "\"gain\""), code->fragment.reflection);
    CHECK_MESSAGE(has(code->fragment.reflection, "\"picture\""), code->fragment.reflection);
    CHECK_MESSAGE(has(code->vertex.reflection, "\"uv\""), code->vertex.reflection);
}
