#include "looks/drawn_picture.h"

#include "formats/look_format.h"
#include "gpu/context.h"
#include "gpu/readback.h"
#include "lab/renderer.h"

#include <doctest/doctest.h>

Picture drawn_look(const std::string& look, const Picture& source, const Values& values,
                   const std::string& pass) {
    const auto shaders = std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders";
    LoadedLook loaded = load_look(shaders / look, shaders / "include");
    REQUIRE_MESSAGE(loaded.look.has_value(), (loaded.look ? "" : to_string(loaded.look.error())));
    for (Pass& target : loaded.look->passes)
        target.format = Format::rgba32f;
    const auto context = gpu::Context::headless();
    REQUIRE(context.has_value());
    auto programs = build_programs(*loaded.look);
    REQUIRE_MESSAGE(programs.has_value(), (programs ? "" : to_string(programs.error())));
    Renderer renderer(std::move(*loaded.look), std::move(*programs));
    REQUIRE(renderer.resize(source.extent, source.extent).has_value());
    renderer.set_values(values);
    REQUIRE(renderer.set_source(source).has_value());
    renderer.draw({1, {}}, {});
    const Executor& executor = renderer.executor();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    return gpu::read_picture(
        executor.target(pass.empty() ? last : *find_pass(executor.look(), pass)));
}

Picture flat_field(Extent extent, float red, float green, float blue) {
    Picture field{extent, 3, Encoding::linear, {}};
    for (int i = 0; i < extent.width * extent.height; ++i)
        field.pixels.insert(field.pixels.end(), {red, green, blue});
    return field;
}

double mean_of(const Picture& picture, std::size_t channel, int x, int y, Extent extent) {
    double sum = 0.0;
    for (int row = y; row < y + extent.height; ++row)
        for (int column = x; column < x + extent.width; ++column)
            sum += static_cast<double>(picture.pixels[picture.index(column, row) + channel]);
    return sum / (extent.width * extent.height);
}
