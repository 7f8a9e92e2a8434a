#include "graph/targets/image_texture.h"

#include "gpu/objects/texels.h"
#include "model/picture/solid_picture.h"

#include <fmt/format.h>

#include <algorithm>

bool reads_mipmaps(const Look& look, Input::From from, const std::string& name) {
    return std::ranges::any_of(look.passes, [&](const Pass& pass) {
        return std::ranges::any_of(pass.inputs, [&](const Input& input) {
            return input.from == from && input.sampler.mipmap &&
                   (from == Input::From::source || input.name == name);
        });
    });
}

Result<std::shared_ptr<const gpu::Texture>> image_texture(const Look& look, const std::string& name,
                                                          const Picture& picture) {
    if (picture.extent.is_empty())
        return fail({{}, 0, fmt::format("the picture '{}' is empty", name)});
    const auto declared = std::ranges::find(look.images, name, &Image::name);
    const Image* image = declared == look.images.end() ? nullptr : &*declared;
    if (image && image->shape != picture.shape) {
        const auto solid = solid_of(picture, image->shape);
        if (solid)
            return image_texture(look, name, *solid);
        Diagnostics problems = solid.error();
        for (Diagnostic& problem : problems)
            problem.file = image->file;
        return fail(std::move(problems));
    }
    const bool is_mipmapped = reads_mipmaps(look, Input::From::image, name);
    const Format format = image ? image->format : Format::rgba32f;
    auto texture =
        picture.shape == PictureShape::flat
            ? gpu::Texture::make(picture.extent, format, is_mipmapped)
            : gpu::Texture::make_solid(picture.shape, picture.extent.width, format, is_mipmapped);
    if (!texture)
        return fail(texture.error());
    const bool is_data = image && image->is_linear;
    const Encoding wanted = image && image->encoding ? *image->encoding : look.source_encoding;
    const Encoding encoding = is_data ? picture.encoding : wanted;
    const RowOrder rows = image ? image->rows : RowOrder::bottom_first;
    std::vector<float> texels;
    if (picture.shape == PictureShape::flat) {
        gpu::upload_picture(*texture, picture, encoding, texels, rows);
    } else {
        gpu::fill_texels(picture, encoding, texels, rows);
        texture->upload(texels);
    }
    texture->generate_mipmaps();
    return std::make_shared<const gpu::Texture>(std::move(*texture));
}
