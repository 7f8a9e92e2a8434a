#include "formats/reshade_export/fx_textures.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// Whole numbers only, because #if cannot calculate with others.
const char* const fx_size_macros = R"(
#if AFTERGLOW_CONTENT_WIDTH > 0
    #define afterglow_width AFTERGLOW_CONTENT_WIDTH
#else
    #define afterglow_width BUFFER_WIDTH
#endif
#if AFTERGLOW_CONTENT_HEIGHT > 0
    #define afterglow_height AFTERGLOW_CONTENT_HEIGHT
#else
    #define afterglow_height BUFFER_HEIGHT
#endif
#if AFTERGLOW_SOURCE_LINES > 0
    #define afterglow_lines AFTERGLOW_SOURCE_LINES
#else
    #define afterglow_lines afterglow_height
#endif
#if AFTERGLOW_SOURCE_COLUMNS > 0
    #define afterglow_columns AFTERGLOW_SOURCE_COLUMNS
#else
    #define afterglow_columns ((afterglow_lines * afterglow_width + afterglow_height / 2) / afterglow_height)
#endif
)";

namespace {
bool is_whole(const Side& side) {
    return side.factor == 1.0;
}

std::string side_text(const Side& side, const char* whole, const char* source) {
    if (side.by == Side::By::pixels)
        return fmt::format("{:.0f}", side.factor);
    const char* const base = side.by == Side::By::source ? source : whole;
    return is_whole(side) ? std::string(base)
                          : fmt::format("int({} * {} + 0.5)", base, format_number(side.factor));
}

// Of two sides, the number of mip levels below those of a whole picture.
int fewer_levels(const Pass& pass) {
    const double factor = std::max(pass.size[0].factor, pass.size[1].factor);
    return static_cast<int>(std::floor(std::log2(factor)));
}

int levels_of_pixels(double width, double height) {
    return static_cast<int>(std::log2(std::max({width, height, 1.0}))) + 1;
}

// #if lines that define the number of mip levels of a size.
std::string level_macro(const char* name, const char* width, const char* height) {
    constexpr int most = 14;
    std::string text;
    for (int level = most; level > 1; --level)
        text += fmt::format("#{} {} >= {} || {} >= {}\n    #define {} {}\n",
                            level == most ? "if" : "elif", width, 1 << (level - 1), height,
                            1 << (level - 1), name, level);
    return text + fmt::format("#else\n    #define {} 1\n#endif\n", name);
}

const char* wrap_name(Wrap wrap) {
    switch (wrap) {
        case Wrap::edge:
            return "CLAMP";
        case Wrap::border:
            return "BORDER";
        case Wrap::repeat:
            return "WRAP";
        case Wrap::mirror:
            break;
    }
    return "MIRROR";
}

const char* filter_name(Filter filter) {
    return filter == Filter::linear ? "LINEAR" : "POINT";
}
}  // namespace

const char* fx_format_name(Format format) {
    switch (format) {
        case Format::r8:
            return "R8";
        case Format::rg8:
            return "RG8";
        case Format::rgb10_a2:
            return "RGB10A2";
        case Format::r16f:
            return "R16F";
        case Format::rg16f:
            return "RG16F";
        case Format::rgba16f:
        case Format::r11f_g11f_b10f:
            return "RGBA16F";
        case Format::r32f:
            return "R32F";
        case Format::rg32f:
            return "RG32F";
        case Format::rgba32f:
            return "RGBA32F";
        default:  // integers are refused before
            return "RGBA8";
    }
}

FxTextures::FxTextures(const Look& look, const std::vector<EffectPicture>& pictures,
                       const std::string& prefix)
    : m_look(look), m_pictures(pictures), m_prefix(prefix) {
    for (const Pass& pass : look.passes)
        m_names.add(pass.name);
    for (std::size_t i = 0; i + 1 < look.passes.size(); ++i)
        m_textures[target(i)] = {size_of(look.passes[i].name), look.passes[i].format};
    for (const EffectPicture& picture : pictures) {
        m_names.add(picture.name);
        m_textures[prefix + picture.name] = {size_of(picture.name), Format::rgba8, picture.path};
    }
    m_black = m_names.add("black");
}

FxSize FxTextures::size_of(const std::string& name) const {
    if (const auto pass = find_pass(m_look, name)) {
        const auto& size = m_look.passes[static_cast<std::size_t>(*pass)].size;
        return {side_text(size[0], "afterglow_width", "afterglow_columns"),
                side_text(size[1], "afterglow_height", "afterglow_lines")};
    }
    for (const EffectPicture& picture : m_pictures)
        if (picture.name == name)
            return {std::to_string(picture.file.picture.extent.width),
                    std::to_string(picture.file.picture.extent.height)};
    return {"afterglow_columns", "afterglow_lines"};
}

std::string FxTextures::levels_of(const std::string& name) const {
    if (const auto index = find_pass(m_look, name)) {
        const Pass& pass = m_look.passes[static_cast<std::size_t>(*index)];
        if (pass.size[0].by == Side::By::pixels || pass.size[1].by == Side::By::pixels)
            return std::to_string(levels_of_pixels(pass.size[0].factor, pass.size[1].factor));
        const char* const all =
            pass.size[0].by == Side::By::source ? "afterglow_source_levels" : "afterglow_levels";
        const int fewer = fewer_levels(pass);
        return fewer == 0 ? all : fmt::format("({} {:+})", all, fewer);
    }
    for (const EffectPicture& picture : m_pictures)
        if (picture.name == name)
            return std::to_string(levels_of_pixels(picture.file.picture.extent.width,
                                                   picture.file.picture.extent.height));
    return "afterglow_source_levels";
}

std::string FxTextures::reader(const std::string& texture, const Sampler& sampler) {
    const Reader wanted{texture, sampler};
    const auto known =
        std::ranges::find(m_samplers, wanted, &std::pair<std::string, Reader>::second);
    if (known != m_samplers.end())
        return known->first;
    m_samplers.emplace_back(fmt::format("afterglow_sampler_{}", m_samplers.size()), wanted);
    return m_samplers.back().first;
}

std::string FxTextures::sampler(const Input& input, std::size_t pass) {
    if (input.from == Input::From::source)
        return reader("afterglow_screen", input.sampler);
    std::string texture = m_prefix + input.name;
    if (const auto drawn = find_pass(m_look, input.name)) {
        const auto index = static_cast<std::size_t>(*drawn);
        const int ago = index >= pass ? std::max(input.frames_ago, 1) : input.frames_ago;
        // A pass that comes later still has what it drew in the previous frame.
        const bool has_it = index > pass && ago == 1;
        if (ago > 0 && !has_it)
            texture = before(input.name, ago);
    }
    if (input.sampler.mipmap)
        m_textures[texture].levels = levels_of(input.name);
    return reader(texture, input.sampler);
}

std::string FxTextures::before(const std::string& pass, int frames) {
    std::vector<std::string>& earlier = m_before[pass];
    while (std::ssize(earlier) < frames) {
        earlier.push_back(m_prefix + m_names.add(pass + "_before"));
        m_textures[earlier.back()] = {size_of(pass), m_textures[m_prefix + pass].format};
    }
    return earlier[static_cast<std::size_t>(frames) - 1];
}

std::string FxTextures::black() {
    m_has_black = true;
    m_textures[black_target()] = {{"1", "1"}};
    return reader(black_target(), {.filter = Filter::nearest});
}

std::vector<FxTextures::Copy> FxTextures::copies() {
    std::vector<Copy> copies;
    for (const auto& [pass, earlier] : m_before)
        for (std::size_t i = earlier.size(); i-- > 0;) {
            const std::string from = i > 0 ? earlier[i - 1] : m_prefix + pass;
            copies.push_back({reader(from, {.filter = Filter::nearest}), earlier[i],
                              m_textures.at(earlier[i]).format});
        }
    return copies;
}

std::string FxTextures::declarations() const {
    std::string text;
    if (std::ranges::any_of(m_textures, [](const auto& one) { return !one.second.levels.empty(); }))
        text += level_macro("afterglow_levels", "afterglow_width", "afterglow_height") +
                level_macro("afterglow_source_levels", "afterglow_columns", "afterglow_lines");
    text += "\ntexture2D afterglow_screen : COLOR;\n";
    for (const auto& [name, texture] : m_textures)
        text += fmt::format(
            "texture2D {}{} {{ Width = {}; Height = {}; Format = {}; MipLevels = {}; }};\n", name,
            texture.file.empty() ? "" : fmt::format(" < source = \"{}\"; >", texture.file),
            texture.size.width, texture.size.height, fx_format_name(texture.format),
            texture.levels.empty() ? "1" : texture.levels);
    for (const auto& [name, reader] : m_samplers) {
        const Sampler& sampler = reader.sampler;
        const auto texture = m_textures.find(reader.texture);
        const bool is_srgb =
            texture != m_textures.end() && texture->second.format == Format::srgb8_alpha8;
        text += fmt::format(
            "sampler2D {0} {{ Texture = {1}; AddressU = {2}; AddressV = {2}; MinFilter = {3}; "
            "MagFilter = {3}; MipFilter = {4};{5} }};\n",
            name, reader.texture, wrap_name(sampler.wrap), filter_name(sampler.filter),
            filter_name(sampler.between_levels.value_or(sampler.filter)),
            is_srgb ? " SRGBTexture = true;" : "");
    }
    return text;
}
