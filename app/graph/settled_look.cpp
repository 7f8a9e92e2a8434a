#include "graph/settled_look.h"

#include "glsl/settled_text.h"
#include "graph/parameter_uniforms.h"

namespace {
using Uniforms = std::map<std::string, SettledUniform>;

bool can_settle(const Parameter& parameter) {
    const bool is_picked =
        parameter.control == Control::image || parameter.control == Control::sound;
    return !is_picked && parameter.control != Control::event && !parameter.is_constant &&
           parameter.orbit == OrbitPart::none;
}
}  // namespace

Look settled_look(Look look, const Values& values, const Plan& plan,
                  const std::function<bool(const Parameter&)>& moves) {
    std::vector<Uniforms> uniforms(look.passes.size());
    for (const Parameter& parameter : look.parameters) {
        if (!can_settle(parameter) || moves(parameter))
            continue;
        const Value value = value_for_shaders(parameter, value_of(parameter, values));
        for (const Binding& binding : parameter.bindings)
            if (binding.pass >= 0 && static_cast<std::size_t>(binding.pass) < uniforms.size())
                uniforms[static_cast<std::size_t>(binding.pass)][binding.uniform] = {parameter.type,
                                                                                     value};
    }
    for (std::size_t i = 0; i < uniforms.size(); ++i) {
        for (const BuiltInUniform& told : look.passes[i].built_ins)
            if (told.says == BuiltIn::drawn_onto)
                uniforms[i][told.name] = {{Scalar::boolean, 1, 1},
                                          meets_drawn_onto(look, plan, i) ? 1.0 : 0.0};
        Pass& pass = look.passes[i];
        pass.vertex.text = settled_text(pass.vertex.text, uniforms[i]);
        pass.fragment.text = settled_text(pass.fragment.text, uniforms[i]);
    }
    return look;
}
