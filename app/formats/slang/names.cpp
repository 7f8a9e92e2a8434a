#include "formats/slang/names.h"

#include "base/text.h"

#include <algorithm>
#include <array>

namespace {
using Of = SlangPicture::Of;

constexpr NumberType one_float{Scalar::floating, 1, 1};
constexpr NumberType one_natural{Scalar::unsigned_integer, 1, 1};
constexpr NumberType one_integer{Scalar::integer, 1, 1};
constexpr NumberType three_floats{Scalar::floating, 3, 1};
constexpr NumberType four_floats{Scalar::floating, 4, 1};
constexpr NumberType matrix{Scalar::floating, 4, 4};

// Constant without rewinding, rotation or sensors.
constexpr std::array slang_members{
    SlangMember{"MVP", matrix, BuiltIn::quad_to_clip},
    SlangMember{"OutputSize", four_floats, BuiltIn::target_extent},
    SlangMember{"FinalViewportSize", four_floats, BuiltIn::output_extent},
    SlangMember{"FrameCount", one_natural, BuiltIn::source_frame_index},
    SlangMember{"FrameTimeDelta", one_natural, BuiltIn::microseconds},
    SlangMember{"OriginalAspect", one_float, BuiltIn::source_aspect},
    SlangMember{"OriginalAspectRotated", one_float, BuiltIn::source_aspect},
    SlangMember{"FrameDirection", one_integer, std::nullopt, 1.0},
    SlangMember{"OriginalFPS", one_float, std::nullopt, 60.0},
    SlangMember{"Rotation", one_natural, std::nullopt, 0.0},
    SlangMember{"TotalSubFrames", one_natural, BuiltIn::subframes},
    SlangMember{"CurrentSubFrame", one_natural, BuiltIn::subframe_number},
    SlangMember{"HDRMode", one_natural, BuiltIn::hdr_mode},
    SlangMember{"SubpixelLayout", one_natural, std::nullopt, 0.0},
    SlangMember{"ExpandGamut", one_natural, std::nullopt, 0.0},
    SlangMember{"BrightnessNits", one_float, BuiltIn::paper_white},
    SlangMember{"Scanlines", one_float, std::nullopt, 0.0},
    SlangMember{"InverseTonemap", one_float, std::nullopt, 0.0},
    SlangMember{"HDR10", one_float, std::nullopt, 0.0},
    SlangMember{"Gyroscope", three_floats, std::nullopt, 0.0},
    SlangMember{"Accelerometer", three_floats, std::nullopt, 0.0},
    SlangMember{"AccelerometerRest", three_floats, std::nullopt, 0.0},
};

// A name of the format that ends with a number. "OriginalHistory" precedes "Original".
struct NumberedName {
    std::string_view name;
    Of of;
};
constexpr std::array numbered_names{
    NumberedName{"OriginalHistory", Of::original}, NumberedName{"PassOutput", Of::output},
    NumberedName{"PassFeedback", Of::feedback}, NumberedName{"User", Of::image}};

std::optional<SlangPicture> find_numbered(std::string_view name, std::string_view behind) {
    constexpr int maximum =
        128;  // history frames of RetroArch; there are fewer passes and textures
    for (const NumberedName& numbered : numbered_names) {
        const std::string prefix = std::string(numbered.name) + std::string(behind);
        if (!name.starts_with(prefix))
            continue;
        const std::string_view digits = name.substr(prefix.size());
        const bool is_number = !digits.empty() && std::ranges::all_of(digits, [](char c) {
            return c >= '0' && c <= '9';
        });
        const auto number = is_number ? parse_integer(digits) : std::nullopt;
        if (number && *number <= maximum)
            return SlangPicture{numbered.of, *number};
    }
    return std::nullopt;
}

std::optional<std::string_view> without_end(std::string_view text, std::string_view end) {
    if (!text.ends_with(end) || text.size() == end.size())
        return std::nullopt;
    return text.substr(0, text.size() - end.size());
}
}  // namespace

SlangNames::SlangNames(std::vector<std::string> aliases, std::vector<std::string> images)
    : m_aliases(std::move(aliases)), m_images(std::move(images)) {}

std::optional<SlangPicture> SlangNames::find_own(std::string_view name) const {
    const auto index_in = [](const std::vector<std::string>& names, std::string_view wanted) {
        const auto found = std::ranges::find(names, wanted);
        return wanted.empty() || found == names.end()
                   ? std::nullopt
                   : std::optional(static_cast<int>(found - names.begin()));
    };
    if (const auto pass = index_in(m_aliases, name))
        return SlangPicture{Of::output, *pass};
    if (const auto alias = without_end(name, "Feedback"))
        if (const auto pass = index_in(m_aliases, *alias))
            return SlangPicture{Of::feedback, *pass};
    if (const auto image = index_in(m_images, name))
        return SlangPicture{Of::image, *image};
    return std::nullopt;
}

std::optional<SlangPicture> SlangNames::find(std::string_view sampler) const {
    if (const auto own = find_own(sampler))
        return own;
    if (sampler == "Original")
        return SlangPicture{Of::original, 0};
    if (sampler == "Source")
        return SlangPicture{Of::source, 0};
    return find_numbered(sampler, "");
}

std::optional<SlangPicture> SlangNames::find_size(std::string_view member) const {
    if (const auto name = without_end(member, "Size"))
        if (const auto own = find_own(*name))
            return own;
    if (member == "OriginalSize")
        return SlangPicture{Of::original, 0};
    if (member == "SourceSize")
        return SlangPicture{Of::source, 0};
    return find_numbered(member, "Size");
}

const SlangMember* find_slang_member(std::string_view name) {
    const auto* const found = std::ranges::find(slang_members, name, &SlangMember::name);
    return found == slang_members.end() ? nullptr : &*found;
}
