#include "graph/programs/specialized_look.h"

#include "graph/programs/parameter_uniforms.h"

#include <algorithm>

namespace {
using Uniforms = std::map<std::string, SpecializedUniform>;

bool can_be_constant(const Parameter& parameter) {
    const bool is_picked =
        parameter.control == Control::image || parameter.control == Control::sound;
    return !is_picked && parameter.control != Control::event && !parameter.is_constant &&
           parameter.orbit == OrbitPart::none;
}
}  // namespace

void SpecializedTexts::begin_look() {
    constexpr int oldest = 8;
    for (Specialized& specialized : m_specialized)
        ++specialized.age;
    std::erase_if(m_specialized,
                  [](const Specialized& specialized) { return specialized.age > oldest; });
}

SharedText SpecializedTexts::of(const SharedText& text, const Uniforms& uniforms) {
    const auto found = std::ranges::find_if(m_specialized, [&](const Specialized& specialized) {
        return specialized.text == text && specialized.uniforms == uniforms;
    });
    if (found != m_specialized.end()) {
        found->age = 0;
        return found->made;
    }
    m_specialized.push_back({text, uniforms, SharedText(specialized_text(text, uniforms))});
    return m_specialized.back().made;
}

Look specialized_look(Look look, const Values& values, const Plan& plan,
                      const std::function<bool(const Parameter&)>& moves, SpecializedTexts& texts) {
    texts.begin_look();
    std::vector<Uniforms> uniforms(look.passes.size());
    for (const Parameter& parameter : look.parameters) {
        if (!can_be_constant(parameter) || moves(parameter))
            continue;
        const Value value = value_for_shaders(parameter, value_of(parameter, values));
        for (const Binding& binding : parameter.bindings)
            if (binding.pass >= 0 && static_cast<std::size_t>(binding.pass) < uniforms.size())
                uniforms[static_cast<std::size_t>(binding.pass)][binding.uniform] = {parameter.type,
                                                                                     value};
    }
    for (std::size_t i = 0; i < uniforms.size(); ++i) {
        for (const BuiltInUniform& built_in : look.passes[i].built_ins)
            if (built_in.kind == BuiltIn::drawn_onto)
                uniforms[i][built_in.name] = {{Scalar::boolean, 1, 1},
                                              is_drawn_onto(look, plan, i) ? 1.0 : 0.0};
        Pass& pass = look.passes[i];
        pass.vertex.text = texts.of(pass.vertex.text, uniforms[i]);
        pass.fragment.text = texts.of(pass.fragment.text, uniforms[i]);
    }
    return look;
}
