#include "looks/glsl_function.h"

#include "formats/look_format.h"
#include "gpu/headless_context.h"
#include "gpu/objects/readback.h"
#include "io/temporary_folder.h"
#include "lab/rendering/executors.h"
#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
constexpr const char* manifest = R"({ "format": "afterglow-look", "version": 1, "name": "Function",
  "driven_by": "picture", "default_source": "pattern:white", "output": "linear",
  "passes": [ { "name": "f", "fragment": "f.frag", "format": "rgba32f",
                "inputs": { "inputs": "source" } } ] })";

constexpr const char* caller = R"(
uniform sampler2D inputs;
out vec4 color;
void main() {
    color = f(texelFetch(inputs, ivec2(gl_FragCoord.xy), 0));
}
)";

constexpr int width = 256;

Picture as_picture(const std::vector<Vec4>& inputs) {
    const int height = (static_cast<int>(inputs.size()) + width - 1) / width;
    Picture picture{{width, height}, 4, Encoding::linear, {}};
    picture.pixels.resize(picture.index(0, height));
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            picture.pixels[i * 4 + c] = static_cast<float>(inputs[i][c]);
    return picture;
}
}  // namespace

std::vector<Vec4> run_glsl(const std::string& body, const std::vector<Vec4>& inputs) {
    const TemporaryFolder folder;
    folder.write("function/look.json", manifest);
    folder.write("function/f.frag", "#version 410 core\n" + body + caller);
    const LoadedLook loaded = load_look(
        folder / "function", std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders" / "include");
    REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));

    const auto context = gpu::create_headless_context();
    REQUIRE(context.has_value());
    auto programs = build_programs(*loaded.look);
    REQUIRE_MESSAGE(programs.has_value(), problems_of(programs));
    Executors executors(Executor(*loaded.look, std::move(*programs)));
    const Picture source = as_picture(inputs);
    REQUIRE(executors.picture().resize(source.extent, source.extent).has_value());
    REQUIRE(executors.set_source(source).has_value());
    executors.draw({1, {}}, {});

    const Picture drawn = gpu::read_picture(executors.picture().target(0));
    std::vector<Vec4> results(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            results[i][c] = static_cast<double>(drawn.pixels[i * 4 + c]);
    return results;
}

Vec4 run_glsl(const std::string& body, const Vec4& input) {
    return run_glsl(body, std::vector<Vec4>{input}).front();
}

std::vector<Vec4> ramp_inputs(double first, double last, int count) {
    std::vector<Vec4> inputs;
    for (int i = 0; i < count; ++i) {
        const double x = first + (last - first) * i / (count - 1);
        inputs.push_back({x, x, x, 1.0});
    }
    return inputs;
}
