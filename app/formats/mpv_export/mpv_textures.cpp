#include "formats/mpv_export/mpv_textures.h"

#include "formats/mpv_export/mpv_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr int usual_levels = 8;
constexpr int fewest_levels = 4;
constexpr std::size_t max_binds = 14;  // besides HOOKED: each has a vertex attribute
}  // namespace

MpvTextures::MpvTextures(const Look& look) : m_look(look), m_levels(usual_levels) {
    limit_levels();
}

// The largest number of textures of a pass.
void MpvTextures::limit_levels() {
    const auto fits = [&] {
        return std::ranges::all_of(
            m_look.passes, [&](const Pass& pass) { return binds_of(pass).size() <= max_binds; });
    };
    while (m_levels > fewest_levels && !fits())
        --m_levels;
}

std::string MpvTextures::obstacle() const {
    for (const Pass& pass : m_look.passes)
        if (const std::size_t count = binds_of(pass).size(); count > max_binds)
            return fmt::format(
                "The pass '{}' reads {} textures, with mip levels. mpv allows {}. Export the look "
                "with --to web or --to slang.",
                pass.name, count, max_binds);
    return {};
}

std::string MpvTextures::name_of(const Pass& pass) {
    return fmt::format("{}pass_{}", mpv_prefix, pass.name);
}

std::string MpvTextures::name_of(const Input& input) const {
    switch (input.from) {
        case Input::From::source:
            return "HOOKED";
        case Input::From::image:
            return fmt::format("{}picture_{}", mpv_prefix, input.name);
        default:
            return fmt::format("{}pass_{}", mpv_prefix, input.name);
    }
}

std::string MpvTextures::sampler_of(const Input& input) const {
    return input.from == Input::From::image ? name_of(input) : name_of(input) + "_raw";
}

std::string MpvTextures::level_name(const Input& input, int level) const {
    return level == 0 ? name_of(input)
                      : fmt::format("{}level_{}_of_{}", mpv_prefix, level,
                                    name_of(input).substr(std::string_view(mpv_prefix).size()));
}

std::vector<std::string> MpvTextures::binds_of(const Pass& pass) const {
    std::vector<std::string> names;
    for (const Input& input : pass.inputs)
        for (int level = 0; level <= levels_of(input); ++level) {
            std::string name = level_name(input, level);
            if (name != "HOOKED" && std::ranges::find(names, name) == names.end())
                names.push_back(std::move(name));
        }
    return names;
}

const Pass* MpvTextures::pass_of(const Input& input) const {
    const auto index =
        input.from == Input::From::pass ? find_pass(m_look, input.name) : std::nullopt;
    return index ? &m_look.passes[static_cast<std::size_t>(*index)] : nullptr;
}

bool MpvTextures::is_bytes(const Input& input) const {
    if (input.from == Input::From::source)
        return m_look.source_format == Format::rgba8;
    const Pass* const pass = pass_of(input);
    return pass && pass->format == Format::rgba8;
}

std::string MpvTextures::level_side(const Input& input, int level, char axis) const {
    if (input.from == Input::From::image) {
        const Extent& extent = m_extents.at(input.name);
        return fmt::format("{}",
                           std::max(1, (axis == 'w' ? extent.width : extent.height) >> level));
    }
    // half the size of the level before, rounded down, at least 1
    return fmt::format("{0}.{1} {0}.{1} 2 % - 2 / {0}.{1} 2 < +", level_name(input, level - 1),
                       axis);
}

std::vector<MpvBlock> MpvTextures::levels(const Input& input) const {
    std::vector<MpvBlock> blocks;
    for (int level = 1; level <= m_levels; ++level) {
        const std::string before = level_name(input, level - 1);
        const std::string sampler = level == 1 ? sampler_of(input) : before + "_raw";
        blocks.push_back({
            .about = fmt::format("{}: mip level {} of {}", m_look.name, level, input.name),
            .binds = {before},
            .save = level_name(input, level),
            .width = level_side(input, level, 'w'),
            .height = level_side(input, level, 'h'),
            .values = {},
            .body =
                fmt::format("vec4 hook() {{ return textureLod({}, HOOKED_pos, 0.0); }}\n", sampler),
        });
    }
    return blocks;
}

std::vector<MpvBlock> MpvTextures::level_blocks(const Pass& pass) {
    std::vector<MpvBlock> blocks;
    for (const Input& input : pass.inputs) {
        const std::string name = name_of(input);
        if (!input.sampler.mipmap || std::ranges::find(m_drawn, name) != m_drawn.end())
            continue;
        m_drawn.push_back(name);
        for (MpvBlock& block : levels(input))
            blocks.push_back(std::move(block));
    }
    return blocks;
}

Result<std::string> MpvTextures::picture_blocks() {
    std::string text;
    for (const Image& image : m_look.images) {
        const Input read{{}, Input::From::image, image.name, 0, {}};
        const auto is_read = [&](const Pass& pass) {
            return std::ranges::any_of(pass.inputs, [&](const Input& input) {
                return input.from == Input::From::image && input.name == image.name;
            });
        };
        if (std::ranges::none_of(m_look.passes, is_read))
            continue;
        auto picture = mpv_picture(m_look, image);
        if (!picture)
            return fail(picture.error());
        m_extents[image.name] = picture->extent;
        text += fmt::format("\n//!TEXTURE {}\n{}", name_of(read), picture->lines);
    }
    return text;
}
