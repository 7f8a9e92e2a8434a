#include "formats/effect/effect_pictures.h"

#include "io/pictures/picture_file.h"
#include "signals/patterns/generated_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
Sampler sampler_of_image(const Look& look, const std::string& name) {
    for (const Pass& pass : look.passes)
        for (const Input& input : pass.inputs)
            if (input.from == Input::From::image && input.name == name)
                return input.sampler;
    return {};
}

Picture turned_over(Picture picture) {
    const auto row = static_cast<std::ptrdiff_t>(picture.extent.width) * picture.channels;
    auto top = picture.pixels.begin();
    auto bottom = picture.pixels.end();
    for (int y = 0; y < picture.extent.height / 2; ++y, top += row)
        std::swap_ranges(top, top + row, bottom -= row);
    return picture;
}

Picture black_picture() {
    return {.extent = {1, 1},
            .channels = 4,
            .encoding = Encoding::display,
            .pixels = {0.0f, 0.0f, 0.0f, 0.0f}};
}

Result<EffectPicture> picture_file(const Look& look, const Image& image, const std::string& folder,
                                   RowOrder rows) {
    auto picture = image.made.empty() ? load_picture(image.file) : made_picture(image.made);
    if (!picture && !image.is_needed)
        picture = black_picture();
    if (!picture)
        return fail(picture.error());
    const Encoding wanted = image.encoding.value_or(look.source_encoding);
    if ((!image.is_linear && wanted == Encoding::linear) || picture->encoding == Encoding::linear)
        return fail({image.file, 0,
                     "A picture file with 8 bits is too coarse for linear light. "
                     "Export the look with --to web or --to portable."});
    if (image.rows != rows)
        picture = turned_over(std::move(*picture));
    auto file = exact_picture_file(*picture);
    if (!file)
        return fail(file.error());
    const std::string path = fmt::format("{}/{}{}", folder, image.name, file->extension);
    return EffectPicture{image.name, path, sampler_of_image(look, image.name), std::move(*file)};
}
}  // namespace

Result<std::vector<EffectPicture>> effect_pictures(const Look& look, const std::string& folder,
                                                   RowOrder rows, const std::string& black) {
    std::vector<EffectPicture> files;
    for (const Image& image : look.images) {
        auto file = picture_file(look, image, folder, rows);
        if (!file)
            return fail(file.error());
        files.push_back(std::move(*file));
    }
    if (!black.empty()) {
        auto file = exact_picture_file(black_picture());
        if (!file)
            return fail(file.error());
        files.push_back({black, fmt::format("{}/{}.png", folder, black), {}, std::move(*file)});
    }
    return files;
}
