#include "formats/mpv_export/mpv_values.h"

#include "formats/effect/built_in_value.h"
#include "formats/mpv_export/mpv_textures.h"

#include <fmt/format.h>

namespace {
/// What a block knows. mpv has no clock for shaders, so 60 frames are a second.
class MpvHost final : public HostValues {
public:
    MpvHost(const Look& look, const Pass& pass) : m_look(look), m_pass(pass) {}

    HostSize target() override { return {"afterglow_target"}; }
    HostSize output() override { return {"afterglow_output"}; }
    HostSize source() override { return raster(); }
    HostSize raster() override { return {size_of(m_pass.source)}; }
    // The pixels of a video need not be square.
    std::string aspect() override { return "afterglow_output.x / afterglow_output.y"; }
    HostSize input(const Input& input) override {
        if (input.from == Input::From::image)
            return {fmt::format("vec2(textureSize({}picture_{}, 0))", mpv_prefix, input.name)};
        return input.from == Input::From::pass ? HostSize{size_of(input.name)} : raster();
    }
    std::string frames_before() override { return "(afterglow_frame - 1)"; }
    std::string time() override { return "float(afterglow_frame) / 60.0"; }
    std::string time_before() override { return "float(afterglow_frame - 1) / 60.0"; }
    std::string time_delta() override { return "1.0 / 60.0"; }
    std::string date() override { return "vec4(2000.0, 1.0, 1.0, float(afterglow_frame) / 60.0)"; }

private:
    std::string size_of(const std::string& pass) const {
        const auto index = find_pass(m_look, pass);
        return index ? mpv_size(m_look.passes[static_cast<std::size_t>(*index)])
                     : "afterglow_source";
    }

    const Look& m_look;
    const Pass& m_pass;
};
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
    if (const auto* built = std::get_if<BuiltInUniform>(&number.setter)) {
        MpvHost host(m_look, m_pass);
        return built_in_value(*built, number.type, m_pass, host);
    }
    return glsl_zero(number.type);
}
