#pragma once

#include "formats/effect/effect_controls.h"
#include "formats/effect/effect_uniforms.h"

#include <map>
#include <set>
#include <string>
#include <vector>

/// The members that a shader needs in its uniform block: their declarations, in order.
class SlangBlock {
public:
    /// `parameters`: the names of a parameter's components in the block, by its own name. Both
    /// arguments live as long as this.
    SlangBlock(const Pass& pass, const std::map<std::string, std::vector<std::string>>& parameters)
        : m_pass(pass), m_parameters(parameters) {}

    /// The expression for a uniform of the pass, in GLSL.
    std::string value(const EffectNumber& number);
    /// The members of a struct, as the arguments of its constructor.
    std::string value(const EffectStruct& of);
    /// Names of parameters that the shader reads.
    const std::set<std::string>& used_parameters() const { return m_used; }
    /// "uniform UBO { ... } global;"
    std::string declaration() const;

private:
    class Values;

    std::string member(const char* type, const std::string& name);
    std::string parameter_value(const Parameter& parameter, const NumberType& type);

    const Pass& m_pass;
    const std::map<std::string, std::vector<std::string>>& m_parameters;
    std::vector<std::pair<std::string, std::string>> m_members;  // type, name
    std::set<std::string> m_used;
};

/// Names that a parameter or pass must not have, because they mean something else in the format.
std::set<std::string, std::less<>> slang_reserved_names();
