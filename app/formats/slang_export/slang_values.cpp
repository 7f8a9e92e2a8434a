#include "formats/slang_export/slang_values.h"

#include "formats/effect/built_in_value.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr const char* block_name = "global";
}  // namespace

std::string SlangBlock::member(const char* type, const std::string& name) {
    const std::pair<std::string, std::string> wanted{type, name};
    if (std::ranges::find(m_members, wanted) == m_members.end())
        m_members.push_back(wanted);
    return fmt::format("{}.{}", block_name, name);
}

/// What RetroArch gives to a pass. It has no clock; libretro cores run at about 60 frames per
/// second.
class SlangBlock::Values final : public HostValues {
public:
    explicit Values(SlangBlock& block) : m_block(block) {}

    HostSize target() override { return size("OutputSize"); }
    HostSize output() override { return size("FinalViewportSize"); }
    HostSize source() override { return texture(m_block.m_pass.source); }
    HostSize raster() override { return source(); }
    HostSize input(const Input& input) override {
        return texture(input.from == Input::From::source ? std::string() : input.name);
    }
    std::string frames_before() override { return natural("FrameCount"); }
    std::string time() override { return fmt::format("float({} + 1u) / 60.0", count()); }
    std::string time_before() override { return fmt::format("float({}) / 60.0", count()); }
    std::string time_delta() override { return "1.0 / 60.0"; }
    std::string date() override { return {}; }
    std::string subframe_number() override { return natural("CurrentSubFrame"); }
    std::string subframes() override { return natural("TotalSubFrames"); }

private:
    HostSize size(const std::string& name) {
        const std::string extent = m_block.member("vec4", name);
        return {extent + ".xy", extent};
    }
    // "": the source picture.
    HostSize texture(const std::string& name) {
        return size(name.empty() ? "OriginalSize" : name + "Size");
    }
    std::string natural(const std::string& name) {
        return fmt::format("int({})", m_block.member("uint", name));
    }
    std::string count() { return m_block.member("uint", "FrameCount"); }

    SlangBlock& m_block;
};

std::string SlangBlock::parameter_value(const Parameter& parameter, const NumberType& type) {
    m_used.insert(parameter.name);
    NumberType scalar = type;
    scalar.rows = scalar.columns = 1;
    std::string parts;
    for (const std::string& name : m_parameters.at(parameter.name)) {
        const std::string number = member("float", name);
        parts += parts.empty() ? "" : ", ";
        switch (type.scalar) {
            case Scalar::floating:
                parts += number;
                break;
            case Scalar::boolean:
                parts += fmt::format("{} > 0.5", number);
                break;
            default:
                parts += fmt::format("{}(round({}))", glsl_name(scalar), number);
        }
    }
    return type.size() == 1 ? parts : fmt::format("{}({})", glsl_name(type), parts);
}

std::string SlangBlock::value(const EffectNumber& number) {
    if (const auto* fixed = std::get_if<Value>(&number.setter))
        return glsl_value(number.type, *fixed);
    if (const auto* built = std::get_if<BuiltInUniform>(&number.setter)) {
        Values values(*this);
        return built_in_value(*built, number.type, m_pass, values);
    }
    if (const auto* parameter = std::get_if<const Parameter*>(&number.setter))
        if (m_parameters.contains((*parameter)->name))
            return parameter_value(**parameter, number.type);
    return glsl_zero(number.type);
}

std::string SlangBlock::value(const EffectStruct& of) {
    std::string parts;
    for (const EffectNumber& number : of.members)
        parts += (parts.empty() ? "" : ", ") + value(number);
    return parts;
}

std::string SlangBlock::declaration() const {
    std::string text = "layout(std140, set = 0, binding = 0) uniform UBO {\n    mat4 MVP;\n";
    for (const auto& [type, name] : m_members)
        text += fmt::format("    {} {};\n", type, name);
    return text + fmt::format("}} {};\n", block_name);
}

std::set<std::string, std::less<>> slang_reserved_names() {
    return {"MVP",
            "Source",
            "Original",
            "OriginalSize",
            "SourceSize",
            "OutputSize",
            "FinalViewportSize",
            "FrameCount",
            "CurrentSubFrame",
            "TotalSubFrames",
            "Position",
            "TexCoord",
            "FragColor",
            "vTexCoord",
            "UBO",
            "global",
            "source",
            "texture",
            "main"};
}
