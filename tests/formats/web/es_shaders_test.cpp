#include "formats/web/es_shaders.h"

#include <doctest/doctest.h>

namespace {
Pass pass_with(std::string_view fragment) {
    Pass pass;
    pass.name = "glow";
    pass.vertex.text = "#version 410 core\nvoid main() { gl_Position = vec4(0, 0, 0, 1); }\n";
    pass.fragment.text = "#version 410 core\nout vec4 color;\n" + std::string(fragment);
    return pass;
}

Parameter constant(const std::string& name, int passes) {
    Parameter parameter;
    parameter.name = name;
    parameter.is_constant = true;
    for (int i = 0; i < passes; ++i)
        parameter.bindings.push_back({i, name});
    return parameter;
}
}  // namespace

TEST_CASE("a page changes constants that all passes define as numbers") {
    Look look;
    look.passes = {pass_with("#define STEPS 8  // @range 1 9\n#define LEVEL 2  // @range 1 9\n"
                             "void main() { color = vec4(STEPS * LEVEL); }\n"),
                   pass_with("#define LEVEL 2  // @range 1 9\n#if LEVEL > 1\n"
                             "void main() { color = vec4(0); }\n#endif\n")};
    look.parameters = {constant("LEVEL", 2), constant("STEPS", 1)};
    const auto shaders = es_shaders(look);
    REQUIRE(shaders);
    CHECK(shaders->constants == std::vector<EsConstant>{{"STEPS", 1}});
}

TEST_CASE("a constant that prevents the translation keeps its value") {
    Look look;
    look.passes = {
        pass_with("#define SIDE 1  // @range 0 3\nlayout(location = SIDE) out vec4 "
                  "more;\nvoid main() { color = more = vec4(0); }\n")};
    look.parameters = {constant("SIDE", 1)};
    const auto shaders = es_shaders(look);
    REQUIRE(shaders);
    CHECK(shaders->constants.empty());
}

TEST_CASE("an error names the pass") {
    Look look;
    look.passes = {pass_with("uniform dvec2 size;\nvoid main() { color = vec4(size, 0, 1); }\n")};
    const auto shaders = es_shaders(look);
    REQUIRE_FALSE(shaders);
    CHECK_MESSAGE(shaders.error().front().message.starts_with("pass 'glow': "),
                  shaders.error().front().message);
}

TEST_CASE("the pictures that a pass reads are counted") {
    Look look;
    look.passes = {
        pass_with("uniform sampler2D one;\nuniform usampler2D two;\nuniform samplerCube "
                  "unread;\nvoid main() { color = texture(one, vec2(0)) + "
                  "vec4(texture(two, vec2(0))); }\n")};
    const auto shaders = es_shaders(look);
    REQUIRE(shaders);
    CHECK(pictures_read(*shaders, 0) == 2);
}
