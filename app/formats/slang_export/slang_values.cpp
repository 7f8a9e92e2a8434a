#include "formats/slang_export/slang_values.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr const char* block = "global";

// The type of an expression for a built-in value.
NumberType natural_type(BuiltIn kind) {
    switch (kind) {
        case BuiltIn::target_size:
        case BuiltIn::output_size:
        case BuiltIn::source_size:
        case BuiltIn::mouse:
            return {Scalar::floating, 2, 1};
        case BuiltIn::source_lines:
        case BuiltIn::source_columns:
        case BuiltIn::target_resolution:
        case BuiltIn::input_resolution:
            return {Scalar::floating, 3, 1};
        case BuiltIn::press:
        case BuiltIn::date:
        case BuiltIn::date_from_0:
        case BuiltIn::target_extent:
        case BuiltIn::output_extent:
        case BuiltIn::input_extent:
            return {Scalar::floating, 4, 1};
        case BuiltIn::view:
        case BuiltIn::camera:
        case BuiltIn::quad_to_clip:
            return {Scalar::floating, 4, 4};
        case BuiltIn::frame:
        case BuiltIn::frame_index:
        case BuiltIn::samples:
            return {Scalar::integer, 1, 1};
        case BuiltIn::drawn_onto:
            return {Scalar::boolean, 1, 1};
        default:
            return {};
    }
}

std::string converted(const std::string& expression, const NumberType& from, const NumberType& to) {
    return from == to ? expression : fmt::format("{}({})", glsl_name(to), expression);
}
}  // namespace

std::string SlangBlock::member(const char* type, const std::string& name) {
    const std::pair<std::string, std::string> wanted{type, name};
    if (std::ranges::find(m_members, wanted) == m_members.end())
        m_members.push_back(wanted);
    return fmt::format("{}.{}", block, name);
}

std::string SlangBlock::time_value(BuiltIn kind) {
    const std::string count = member("uint", "FrameCount");
    const std::string frame =
        m_pass.frame_modulo > 0 ? fmt::format("({} % {}u)", count, m_pass.frame_modulo) : count;
    switch (kind) {
        case BuiltIn::time:
            return fmt::format("float({} + 1u) / 60.0", count);
        case BuiltIn::time_before:
            return fmt::format("float({}) / 60.0", count);
        case BuiltIn::delta_before:
            return fmt::format("({} == 0u ? 0.0 : 1.0 / 60.0)", count);
        case BuiltIn::frame:
            return fmt::format("int({}) + 1", frame);
        case BuiltIn::frame_index:
            return fmt::format("int({})", frame);
        case BuiltIn::time_delta:
            return "1.0 / 60.0";
        case BuiltIn::microseconds:
            return "16667.0";
        case BuiltIn::frame_rate:
            return "60.0";
        default:
            return glsl_zero(natural_type(kind));
    }
}

std::string SlangBlock::built_in(const BuiltInUniform& uniform) {
    const auto size_of = [&](const std::string& texture) {
        return member("vec4", texture.empty() ? "OriginalSize" : texture + "Size");
    };
    const std::string& source = m_pass.source;
    const std::string of =
        uniform.of && uniform.of->from != Input::From::source ? uniform.of->name : std::string();
    switch (uniform.kind) {
        case BuiltIn::samples:
            return "1";
        case BuiltIn::target_size:
            return member("vec4", "OutputSize") + ".xy";
        case BuiltIn::target_resolution:
            return fmt::format("vec3({}.xy, 1.0)", member("vec4", "OutputSize"));
        case BuiltIn::target_extent:
            return member("vec4", "OutputSize");
        case BuiltIn::output_size:
            return member("vec4", "FinalViewportSize") + ".xy";
        case BuiltIn::output_extent:
            return member("vec4", "FinalViewportSize");
        case BuiltIn::source_size:
            return size_of(source) + ".xy";
        case BuiltIn::source_lines:
            return fmt::format("vec3(0.0, {0}.w, {0}.y)", size_of(source));
        case BuiltIn::source_columns:
            return fmt::format("vec3(0.0, {0}.z, {0}.x)", size_of(source));
        case BuiltIn::source_aspect:
            return fmt::format("{0}.x / {0}.y", size_of(source));
        case BuiltIn::input_extent:
            return size_of(of);
        case BuiltIn::input_resolution:
            return fmt::format("vec3({}.xy, 1.0)", size_of(of));
        case BuiltIn::quad_to_clip:
            return fmt::format(
                "mat4(2.0, 0.0, 0.0, 0.0, 0.0, {0}2.0, 0.0, 0.0, 0.0, 0.0, 1.0, "
                "0.0, -1.0, {1}1.0, 0.0, 1.0)",
                m_pass.rows == RowOrder::top_first ? "" : "-",
                m_pass.rows == RowOrder::top_first ? "-" : "");
        default:
            return tells_time(uniform.kind) ? time_value(uniform.kind)
                                            : glsl_zero(natural_type(uniform.kind));
    }
}

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
    if (const auto* built = std::get_if<BuiltInUniform>(&number.setter))
        return converted(built_in(*built), natural_type(built->kind), number.type);
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
    return text + fmt::format("}} {};\n", block);
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
