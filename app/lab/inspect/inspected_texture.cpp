#include "lab/inspect/inspected_texture.h"

#include "graph/inspect/level_copy.h"

#include <algorithm>

namespace {
// Images with data are displayed without conversion.
Encoding encoding_in(const Look& look, const TextureChoice& choice) {
    if (choice.from == Input::From::pass)
        return encoding_of(look, find_pass(look, choice.name).value_or(0));
    if (choice.from == Input::From::sound)
        return Encoding::display;  // displayed without conversion
    const auto image = std::ranges::find(look.images, choice.name, &Image::name);
    if (choice.from == Input::From::source || image == look.images.end())
        return look.source_encoding;
    return image->is_linear ? Encoding::display : image->encoding.value_or(look.source_encoding);
}
}  // namespace

Extent InspectedTexture::extent_of(int level) const {
    return level_extent(texture->extent(), level);
}

int InspectedTexture::levels() const {
    return level_count(*texture);
}

std::optional<InspectedTexture> inspected_texture(const Executor& executor, const PassView& view) {
    const auto pass = find_pass(executor.look(), view.pass);
    if (!pass)
        return std::nullopt;
    const TextureChoice own{Input::From::pass, view.pass};
    InspectedTexture found{*pass, view.other.value_or(own)};
    found.texture = executor.texture(found.choice);
    if (!found.texture || found.choice.level >= level_count(*found.texture)) {
        found.choice = own;
        found.texture = executor.texture(own);
    }
    if (!found.texture)
        return std::nullopt;
    const bool is_light = found.choice.level > 0 && found.texture->format() == Format::srgb8_alpha8;
    found.encoding = is_light ? Encoding::linear : encoding_in(executor.look(), found.choice);
    return found;
}

int frame_count(const Executor& executor, const TextureChoice& choice) {
    TextureChoice older = choice.current();
    while (executor.texture(older))
        ++older.frames_ago;
    return older.frames_ago;
}
