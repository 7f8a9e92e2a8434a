// Output of single fragment shaders.
#include "io/temporary_folder.h"
#include "lab/offline/offline.h"
#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
// The middle of the right texel of a 2 x 1 px picture after `frames` frames.
std::array<float, 4> fragment_texel(const std::string& text, int frames) {
    const TemporaryFolder folder;
    RenderRequest request;
    request.look = folder.write("a.frag", text).string();
    request.size = {2, 1};
    const auto roots = find_roots({});
    REQUIRE(roots.has_value());
    auto prepared = prepare(request, Library(*roots));
    REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
    auto offline = Offline::create(std::move(*prepared), request.size, 60.0);
    REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
    for (int frame = 0; frame < frames; ++frame)
        offline->advance();
    const Picture picture = offline->picture();
    const float* at = &picture.pixels[picture.index(1, 0)];
    return {at[0], at[1], at[2], at[3]};
}
}  // namespace

TEST_CASE("inputs with explicit locations get values by name") {
    const auto drawn = fragment_texel(
        "#version 450\nlayout(location = 1) in vec2 uv;\nlayout(location = 0) in vec4 tint;\n"
        "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(uv, tint.b, 1.0); }\n",
        1);
    CHECK(drawn[0] == doctest::Approx(0.75).epsilon(0.01));
    CHECK(drawn[1] == doctest::Approx(0.5).epsilon(0.01));
    CHECK(drawn[2] == 1.0f);
}

TEST_CASE("members of blocks and arrays get values by name") {
    const auto drawn = fragment_texel(
        "#version 330\nin VS_OUT { vec2 uv; vec3 normal; } fs_in;\nin vec2 taps[3];\nout vec4 o;\n"
        "void main() { o = vec4(fs_in.uv.x, fs_in.normal.z, taps[2].x, 1.0); }\n",
        1);
    CHECK(drawn[0] == doctest::Approx(0.75).epsilon(0.01));
    CHECK(drawn[1] == 1.0f);
    CHECK(drawn[2] == doctest::Approx(0.75).epsilon(0.01));
}

TEST_CASE("glslViewer double buffers accumulate, buffers start empty, and months count from 0") {
    const auto drawn = fragment_texel(
        "uniform vec4 u_date;\nuniform sampler2D u_buffer0;\nuniform sampler2D u_doubleBuffer0;\n"
        "void main() {\n"
        "#ifdef BUFFER_0\n    gl_FragColor = vec4(0.125);\n"
        "#elif defined(DOUBLE_BUFFER_0)\n"
        "    gl_FragColor = texture2D(u_doubleBuffer0, vec2(0.5)) + texture2D(u_buffer0, "
        "vec2(0.5));\n"
        "#else\n    gl_FragColor = vec4(texture2D(u_doubleBuffer0, vec2(0.5)).r, u_date.y, "
        "u_date.x / 2000.0, 1.0);\n#endif\n}\n",
        3);
    CHECK(drawn[0] == doctest::Approx(0.375).epsilon(0.01));
    CHECK(drawn[1] == 0.0f);
    CHECK(drawn[2] == 1.0f);
}
