#include "lab/views/displayed_texture.h"

TexelValues::Subject DisplayedTexture::cells(Extent room, Extent minimum,
                                             std::uint64_t picture) const {
    return {.texture = *texture,
            .name = name,
            .whole = whole,
            .position = position_of(view, whole, room),
            .size = room,
            .minimum = minimum,
            .picture = picture,
            .options = options};
}

namespace {
bool fit(std::optional<gpu::Canvas>& canvas, Extent extent) {
    if (canvas && canvas->texture().extent() == extent)
        return true;
    canvas.reset();
    if (extent.is_empty())
        return false;
    auto made = gpu::Canvas::make(extent, Format::rgba8);
    if (made)
        canvas.emplace(std::move(*made));
    return made.has_value();
}
}  // namespace

void draw_view(ContextViews& context, const gpu::Texture& from, std::optional<gpu::Canvas>& to,
               Extent size, const DisplayedTexture& displayed) {
    const gpu::ContextScope scope(context.context.get());
    if (!fit(to, size))
        return;
    const PicturePosition position = position_of(displayed.view, displayed.whole, size);
    const double across = static_cast<double>(from.extent().width) / displayed.whole.width;
    const double up = static_cast<double>(from.extent().height) / displayed.whole.height;
    ViewOptions options = displayed.options;
    options.width = size.width / position.zoom * across;
    options.height = size.height / position.zoom * up;
    options.left = -position.left / position.zoom * across;
    options.bottom = from.extent().height + position.top / position.zoom * up - options.height;
    context.viewer.draw(from, *to, options);
}
