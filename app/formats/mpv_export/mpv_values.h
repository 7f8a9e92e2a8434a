#pragma once

#include "formats/effect/effect_controls.h"
#include "formats/effect/effect_uniforms.h"
#include "formats/mpv_export/mpv_parameters.h"

#include <set>
#include <string>

/// The values of a pass's uniforms in mpv, as GLSL expressions.
class MpvValues {
public:
    /// Both live as long as this. `pass`: an index into the look's passes.
    MpvValues(const Look& look, std::size_t pass, const MpvParameters& parameters)
        : m_look(look), m_pass(look.passes[pass]), m_parameters(parameters) {}

    /// The value in the uniform's type.
    std::string value(const EffectNumber& number);
    /// The parameters that the values so far contain.
    const std::set<std::string>& used_parameters() const { return m_used; }

private:
    const Look& m_look;
    const Pass& m_pass;
    const MpvParameters& m_parameters;
    std::set<std::string> m_used;
};

/// The parameter that sets a uniform, if it has a control.
const Parameter* mpv_parameter(const EffectNumber& number, const MpvParameters& parameters);
