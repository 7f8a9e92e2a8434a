#include "lab/offline/thumbnail.h"

#include "gpu/objects/readback.h"

#include <algorithm>
#include <cmath>

namespace {
Extent with_lines(Extent whole, int maximum) {
    const double scale = std::min(1.0, static_cast<double>(maximum) / std::max(whole.height, 1));
    return {std::max(1, static_cast<int>(std::lround(whole.width * scale))),
            std::max(1, static_cast<int>(std::lround(whole.height * scale)))};
}
}  // namespace

Result<gpu::Canvas> thumbnail(Viewer& viewer, const Executor& executor, int height) {
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    const gpu::Texture& picture = executor.target(last);
    auto canvas = gpu::Canvas::make(with_lines(picture.extent(), height), Format::rgba8);
    if (canvas)
        viewer.draw(picture, *canvas, {.encoding = encoding_of(executor.look(), last)});
    return canvas;
}

Extent size_for_small_picture(Extent picture) {
    constexpr int max_lines = 270;
    return with_lines(picture, max_lines);
}

std::optional<Picture> small_copy(const Renderer* renderer) {
    constexpr int lines = 135;
    if (!renderer || !renderer->has_drawn())
        return std::nullopt;
    auto viewer = Viewer::make();
    if (!viewer)
        return std::nullopt;
    const auto canvas = thumbnail(*viewer, renderer->executor(), lines);
    if (!canvas)
        return std::nullopt;
    Picture picture = gpu::read_picture(canvas->texture());
    picture.encoding = Encoding::display;
    return picture;
}
