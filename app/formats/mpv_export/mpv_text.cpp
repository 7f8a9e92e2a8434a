#include "formats/mpv_export/mpv_text.h"

#include "base/text.h"
#include "formats/effect/effect_controls.h"

#include <fmt/format.h>

namespace {
constexpr int max_textures = 16;

std::string number_of(double value) {
    const std::string text = format_number(value);
    return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}
}  // namespace

std::string without_mpv_marks(std::string_view text) {
    return replace_all(text, "//!", "// !");
}

std::string mpv_block_text(const MpvBlock& block) {
    std::string text = fmt::format("\n//!HOOK MAIN\n//!DESC {}\n//!BIND HOOKED\n",
                                   without_mpv_marks(quotable(block.about)));
    for (const std::string& name : block.binds)
        text += fmt::format("//!BIND {}\n", name);
    if (!block.save.empty())
        text += fmt::format("//!SAVE {}\n//!COMPONENTS 4\n", block.save);
    text += fmt::format("//!WIDTH {}\n//!HEIGHT {}\n", block.width, block.height);
    return text + without_mpv_marks(block.values) + without_mpv_marks(block.body);
}

std::string mpv_side(const Side& side, std::size_t axis) {
    if (side.by == Side::By::pixels)
        return fmt::format("{:.0f}", side.factor);
    std::string whole = fmt::format("{}.{}", side.by == Side::By::viewport ? "OUTPUT" : "HOOKED",
                                    axis == 0 ? 'w' : 'h');
    if (side.factor == 1.0)
        return whole;
    const std::string part = fmt::format("{} {:.9f} *", whole, side.factor);
    return side.factor > 1.0 ? part : fmt::format("{0} {0} 0.5 < +", part);  // at least 1
}

std::string mpv_size(const Pass& pass) {
    const auto side = [&](std::size_t axis) {
        const Side& own = pass.size[axis];
        if (own.by == Side::By::pixels)
            return number_of(own.factor);
        const std::string whole =
            fmt::format("{}{}.{}", mpv_prefix, own.by == Side::By::viewport ? "output" : "source",
                        axis == 0 ? 'x' : 'y');
        return own.factor == 1.0
                   ? whole
                   : fmt::format("max(floor({} * {:.9f} + 0.5), 1.0)", whole, own.factor);
    };
    return fmt::format("vec2({}, {})", side(0), side(1));
}

std::vector<std::string> mpv_reserved_words() {
    std::vector<std::string> words{"random",     "frame",   "input_size", "target_size",
                                   "tex_offset", "LUT_POS", "tex1D",      "tex3D",
                                   "linearize",  "hook",    "out_color",  "delinearize"};
    for (int i = 0; i < max_textures; ++i)
        for (const char* name :
             {"texture", "texcoord", "texture_size", "texture_rot", "texture_off", "pixel_size"})
            words.push_back(fmt::format("{}{}", name, i));
    return words;
}

std::string mpv_stored(Format format, const std::string& color) {
    switch (format) {
        case Format::r8:
            return fmt::format("vec4(afterglow_rounded({}).r, 0.0, 0.0, 1.0)", color);
        case Format::rg8:
            return fmt::format("vec4(afterglow_rounded({}).rg, 0.0, 1.0)", color);
        case Format::rgba8:
            return fmt::format("afterglow_rounded({})", color);
        case Format::srgb8_alpha8:
            return fmt::format("afterglow_rounded_in_srgb({})", color);
        case Format::rgb10_a2:
            return fmt::format(
                "floor(clamp({}, 0.0, 1.0) * vec4(vec3(1023.0), 3.0) + 0.5) / "
                "vec4(vec3(1023.0), 3.0)",
                color);
        case Format::r11f_g11f_b10f:
            return fmt::format("vec4(max({}.rgb, 0.0), 1.0)", color);
        case Format::r16f:
        case Format::r32f:
            return fmt::format("vec4({}.r, 0.0, 0.0, 1.0)", color);
        case Format::rg16f:
        case Format::rg32f:
            return fmt::format("vec4({}.rg, 0.0, 1.0)", color);
        default:
            return color;
    }
}
