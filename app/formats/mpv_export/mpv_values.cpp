#include "formats/mpv_export/mpv_values.h"

#include "formats/mpv_export/mpv_textures.h"

#include <fmt/format.h>

namespace {
std::string extent(const std::string& size) {
    return fmt::format("{0}, 1.0 / {0}", size);
}
}  // namespace

const Parameter* mpv_parameter(const EffectNumber& number, const MpvParameters& parameters) {
    const auto* const parameter = std::get_if<const Parameter*>(&number.setter);
    return parameter && parameters.contains(**parameter) ? *parameter : nullptr;
}

std::string MpvValues::value(const EffectNumber& number) {
    if (const auto* fixed = std::get_if<Value>(&number.setter))
        return glsl_value(number.type, *fixed);
    if (const Parameter* const parameter = mpv_parameter(number, m_parameters)) {
        m_used.insert(parameter->name);
        return fmt::format("{}({})", glsl_name(number.type), m_parameters.names_of(*parameter));
    }
    if (const auto* built = std::get_if<BuiltInUniform>(&number.setter))
        if (const std::string text = built_in(*built); !text.empty())
            return fmt::format("{}({})", glsl_name(number.type), text);
    return glsl_zero(number.type);
}

std::string MpvValues::time_value(BuiltIn kind) const {
    const auto frame = [&](const char* number) {
        return m_pass.frame_modulo > 0 ? fmt::format("({}) % {}", number, m_pass.frame_modulo)
                                       : std::string(number);
    };
    switch (kind) {
        case BuiltIn::time:
            return "float(afterglow_frame) / 60.0";
        case BuiltIn::time_before:
            return "float(afterglow_frame - 1) / 60.0";
        case BuiltIn::time_delta:
            return "1.0 / 60.0";
        case BuiltIn::delta_before:
            return "afterglow_frame == 1 ? 0.0 : 1.0 / 60.0";
        case BuiltIn::microseconds:
            return "16667.0";
        case BuiltIn::frame_rate:
            return "60.0";
        case BuiltIn::frame:
            return frame("afterglow_frame");
        case BuiltIn::frame_index:
            return frame("afterglow_frame - 1");
        default:
            return {};
    }
}

std::string MpvValues::source_size() const {
    const auto source = m_pass.source.empty() ? std::nullopt : find_pass(m_look, m_pass.source);
    return source ? mpv_size(m_look.passes[static_cast<std::size_t>(*source)]) : "afterglow_source";
}

std::string MpvValues::size_of(const std::optional<Input>& input) const {
    if (!input || input->from == Input::From::source)
        return source_size();
    const auto pass =
        input->from == Input::From::pass ? find_pass(m_look, input->name) : std::nullopt;
    if (pass)
        return mpv_size(m_look.passes[static_cast<std::size_t>(*pass)]);
    return fmt::format("vec2(textureSize({}picture_{}, 0))", mpv_prefix, input->name);
}

std::string MpvValues::built_in(const BuiltInUniform& uniform) const {
    switch (uniform.kind) {
        case BuiltIn::samples:
            return "1";
        case BuiltIn::target_size:
            return "afterglow_target";
        case BuiltIn::target_resolution:
            return "afterglow_target, 1.0";
        case BuiltIn::target_extent:
            return extent("afterglow_target");
        case BuiltIn::output_size:
            return "afterglow_output";
        case BuiltIn::output_extent:
            return extent("afterglow_output");
        case BuiltIn::source_size:
            return source_size();
        case BuiltIn::source_lines:
            return fmt::format("0.0, 1.0 / {0}.y, {0}.y", source_size());
        case BuiltIn::source_columns:
            return fmt::format("0.0, 1.0 / {0}.x, {0}.x", source_size());
        case BuiltIn::source_aspect:
            return "afterglow_output.x / afterglow_output.y";
        case BuiltIn::input_extent:
            return extent(size_of(uniform.of));
        case BuiltIn::input_resolution:
            return size_of(uniform.of) + ", 1.0";
        case BuiltIn::quad_to_clip:
            return fmt::format(
                "2.0, 0.0, 0.0, 0.0, 0.0, {0}2.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, {1}1.0, "
                "0.0, 1.0",
                m_pass.rows == RowOrder::top_first ? "" : "-",
                m_pass.rows == RowOrder::top_first ? "-" : "");
        case BuiltIn::date:
            return "2000.0, 1.0, 1.0, float(afterglow_frame) / 60.0";
        case BuiltIn::date_from_0:
            return "2000.0, 0.0, 1.0, float(afterglow_frame) / 60.0";
        default:
            return time_value(uniform.kind);
    }
}
