#include "formats/effect/vertex_function.h"

#include "glsl/compile/check.h"
#include "glsl/text/include.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace {
// The fragment shader with the vertex shader as a function.
std::string joined(const Pass& pass) {
    return "#version 410 core\n" +
           effect_text(std::string_view(pass.fragment.text),
                       {.words = {{"main", "fragment_main"}}}) +
           vertex_function(pass, pass.fragment.text, {}).text +
           "out vec4 shown;\nvoid main() { afterglow_vertex_set_inputs(vec2(0.5)); "
           "fragment_main(); shown "
           "= color; "
           "}\n";
}

void check_compiles(const Pass& pass) {
    const auto good = check_program(fullscreen_vertex_stage(), builtin_stage(joined(pass)));
    CHECK_MESSAGE(good.has_value(), (good ? std::string() : good.error().front().message));
}
}  // namespace

TEST_CASE("a vertex shader of its own becomes functions without clashing names") {
    Pass pass;
    pass.draw = Draw::quad;
    pass.vertex = builtin_stage(
        "#version 410 core\nlayout(location = 0) in vec4 position;\n"
        "layout(location = 1) in vec2 corner;\nout vec2 at;\nout vec2 around[2];\n"
        "flat out int which;\nfloat s = 1.0;\nfloat size = 2.0;\nvec2 moved(vec2 a) { return a * "
        "size; }\n"
        "void main() { gl_Position = vec4(2.0 * position.xy - 1.0, 0.0, 1.0); at = moved(corner);\n"
        "around[0] = at; around[1] = -at; which = gl_VertexID; }\n");
    pass.fragment = builtin_stage(
        "#version 410 core\nin vec2 at;\nin vec2 around[2];\nflat in int which;\nout vec4 color;\n"
        "float size = 3.0;\nvec2 moved(vec2 a) { return a + size; }\n"
        "void main() { color = vec4(moved(at), around[1].x, float(which)); }\n");
    CHECK(has_own_vertex(pass));
    check_compiles(pass);
}

TEST_CASE("inputs are matched by location, otherwise by name") {
    Pass pass;
    pass.vertex = builtin_stage(
        "#version 410 core\nlayout(location = 3) out vec2 theirs;\n"
        "void main() { gl_Position = vec4(0.0); theirs = vec2(1.0); }\n");
    pass.fragment = builtin_stage(
        "#version 410 core\nlayout(location = 3) in vec2 ours;\nout vec4 color;\n"
        "void main() { color = vec4(ours, 0.0, 1.0); }\n");
    CHECK(vertex_function(pass, pass.fragment.text, {}).text.find("ours = vertex_theirs_at_0") !=
          std::string::npos);
    check_compiles(pass);
}

TEST_CASE("the built-in vertex shader needs no function") {
    Pass pass;
    CHECK_FALSE(has_own_vertex(pass));
    pass.vertex = fullscreen_vertex_stage();
    CHECK_FALSE(has_own_vertex(pass));
}
