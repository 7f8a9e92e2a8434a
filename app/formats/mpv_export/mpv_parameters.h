#pragma once

#include "formats/effect/effect_controls.h"

#include <map>
#include <set>
#include <string>
#include <vector>

/// The adjustable values of a look: one name per component.
class MpvParameters {
public:
    /// `look` lives as long as this.
    MpvParameters(const Look& look, const Values& values, const std::vector<std::string>& fixed);

    bool contains(const Parameter& parameter) const { return m_names.contains(parameter.name); }
    /// Whether a shader needs a macro for the uniform `name`, because mpv may declare a parameter
    /// of this name. No macro may replace a swizzle, such as "xy".
    bool is_macro(const Parameter& parameter, const std::string& name) const;
    /// "beam_color_r, beam_color_g, beam_color_b"
    std::string names_of(const Parameter& parameter) const;

    /// A `#define` line for each component of these parameters, with label and range.
    std::string defines(const std::set<std::string>& parameters) const;
    /// `#undef` lines for the same names.
    std::string undefines(const std::set<std::string>& parameters) const;
    /// A PARAM block for each component of these parameters.
    std::string blocks(const std::set<std::string>& parameters) const;

private:
    struct Component {
        std::string parameter;
        std::string name;
        std::string label;
        bool is_whole = false;
        double value = 0.0;
        Range range;
    };

    void add(const EffectControl& control, EffectNames& names);

    std::vector<Component> m_components;
    std::map<std::string, std::vector<std::string>> m_names;  // by parameter
};
