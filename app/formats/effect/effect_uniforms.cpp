#include "formats/effect/effect_uniforms.h"

#include "glsl/compile/check.h"
#include "glsl/constants/constants.h"
#include "glsl/text/include.h"
#include "glsl/text/interface_statements.h"
#include "glsl/text/shader_names.h"

#include <algorithm>
#include <limits>

namespace {
const Stage& vertex_of(const Pass& pass) {
    return pass.vertex.text->empty() ? fullscreen_vertex_stage() : pass.vertex;
}

/// Finds what sets the uniforms of one pass.
class Setters {
public:
    Setters(const Look& look, std::size_t pass, const Values& values,
            const std::vector<std::string>& fixed)
        : m_look(look), m_index(pass), m_values(values), m_fixed(fixed) {}

    EffectSetter of(const std::string& uniform) const {
        const Pass& pass = m_look.passes[m_index];
        if (const auto set = pass.set.find(uniform); set != pass.set.end())
            return set->second;
        for (const BuiltInUniform& built_in : pass.built_ins)
            if (built_in.name == uniform)
                return built_in;
        for (const Parameter& parameter : m_look.parameters)
            for (const Binding& binding : parameter.bindings)
                if (binding.pass == static_cast<int>(m_index) && binding.uniform == uniform)
                    return of(parameter);
        return std::monostate{};
    }

private:
    EffectSetter of(const Parameter& parameter) const {
        if (parameter.control == Control::event)
            return Value(0.0);
        const bool is_fixed =
            std::ranges::find(m_fixed, parameter.name) != m_fixed.end() || parameter.is_constant;
        if (is_fixed)
            return value_for_shaders(parameter, value_of(parameter, m_values));
        return &parameter;
    }

    const Look& m_look;
    std::size_t m_index;
    const Values& m_values;
    const std::vector<std::string>& m_fixed;
};

// The structs that a text declares as uniforms.
void add_structs(const Stage& stage, const Setters& setters, std::vector<EffectStruct>& structs) {
    const ShaderNames names = names_at(stage.text, std::numeric_limits<int>::max());
    for (const InterfaceStatement& statement : find_interface_statements(stage.text)) {
        const StructName* const type = names.find_struct(statement.type);
        if (statement.kind != InterfaceStatement::Kind::uniform || !type)
            continue;
        for (const Declarator& one : statement.declarators) {
            const auto is_known = [&](const EffectStruct& known) { return known.name == one.name; };
            if (std::ranges::any_of(structs, is_known))
                continue;
            EffectStruct added{one.name, statement.type, {}};
            for (const TypedName& field : type->fields) {
                const std::string name = one.name + "." + field.name;
                added.members.push_back(
                    {name, number_type_of(field.type).value_or(NumberType{}), setters.of(name)});
            }
            structs.push_back(std::move(added));
        }
    }
}
}  // namespace

Result<EffectUniforms> effect_uniforms(const Look& look, std::size_t index, const Values& values,
                                       const std::vector<std::string>& fixed) {
    const Pass& pass = look.passes[index];
    const auto reflection = check_program(vertex_of(pass), pass.fragment, look.shader_limits);
    if (!reflection)
        return fail(reflection.error());
    const Setters setters(look, index, values, fixed);
    EffectUniforms found;
    for (const Uniform& uniform : reflection->uniforms) {
        const bool is_array = uniform.type_name.find('[') != std::string::npos;
        const auto input = std::ranges::find(pass.inputs, uniform.name, &Input::uniform);
        if (uniform.kind == Uniform::Kind::number && !is_array)
            found.numbers.push_back({uniform.name, uniform.type, setters.of(uniform.name)});
        else if (uniform.kind == Uniform::Kind::sampler && input != pass.inputs.end())
            found.samplers.push_back(*input);
        else if (uniform.kind == Uniform::Kind::sampler)
            found.unread.push_back(uniform.name);
    }
    for (EffectNumber& number : found.numbers)
        if (std::holds_alternative<std::monostate>(number.setter)) {
            const auto uniform =
                std::ranges::find(reflection->uniforms, number.name, &Uniform::name);
            if (uniform->initial)
                number.setter = *uniform->initial;
        }
    add_structs(vertex_of(pass), setters, found.structs);
    add_structs(pass.fragment, setters, found.structs);
    return found;
}

std::string glsl_value(const NumberType& type, const Value& value) {
    NumberType component = type;
    component.rows = component.columns = 1;
    std::string components;
    for (const double number : value.numbers)
        components += (components.empty() ? "" : ", ") + glsl_number(component, number);
    return value.numbers.size() == 1 && type.size() == 1 ? components
                                                         : glsl_name(type) + "(" + components + ")";
}

std::string glsl_zero(const NumberType& type) {
    return glsl_value(type, Value(std::vector<double>(static_cast<std::size_t>(type.size()), 0.0)));
}
