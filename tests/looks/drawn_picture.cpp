#include "looks/drawn_picture.h"

#include "formats/look_format.h"
#include "gpu/headless_context.h"
#include "gpu/objects/readback.h"
#include "lab/rendering/executors.h"
#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
/// A look that is ready to draw. Building its programs takes most of a test's time, so the last one
/// is cached.
struct ReadyLook {
    std::string id;
    std::unique_ptr<gpu::Context> context;
    std::unique_ptr<Executors> executors;
};

ReadyLook make_ready(const std::string& id) {
    const auto shaders = std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "shaders";
    LoadedLook loaded = load_look(shaders / id, shaders / "include");
    REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
    for (Pass& target : loaded.look->passes)
        target.format = Format::rgba32f;
    auto context = gpu::create_headless_context();
    REQUIRE(context.has_value());
    auto programs = build_programs(*loaded.look);
    REQUIRE_MESSAGE(programs.has_value(), problems_of(programs));
    return {id, std::move(*context),
            std::make_unique<Executors>(Executor(std::move(*loaded.look), std::move(*programs)))};
}

Executors& ready(const std::string& id) {
    static ReadyLook kept;
    if (kept.id != id) {
        if (kept.context)
            kept.context->make_current();
        kept.executors.reset();
        kept = make_ready(id);
    }
    kept.context->make_current();
    return *kept.executors;
}
}  // namespace

Picture drawn_look(const std::string& look, const Picture& source, const Values& values,
                   const std::string& pass) {
    return drawn_look_at(look, source.extent, source, values, 1, pass);
}

Picture drawn_look_at(const std::string& look, Extent size, const Picture& source,
                      const Values& values, int number, const std::string& pass) {
    Executors& executors = ready(look);
    REQUIRE(executors.picture().resize(size, source.extent).has_value());
    executors.picture().set_values(values);
    REQUIRE(executors.set_source(source).has_value());
    const double end = number / 60.0;
    executors.draw({number, {number == 1 ? 0.0 : end - 1.0 / 60.0, number == 1 ? 0.0 : end}}, {});
    const Executor& executor = executors.picture();
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
