#include "formats/web/es_shaders.h"

#include "formats/web/compact_glsl.h"
#include "glsl/es/es_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace {
std::size_t index_of(std::string text, std::vector<std::string>& texts) {
    const auto found = std::ranges::find(texts, text);
    if (found != texts.end())
        return static_cast<std::size_t>(found - texts.begin());
    texts.push_back(std::move(text));
    return texts.size() - 1;
}

Result<EsProgram> translated(const Pass& pass, const std::vector<EsConstant>& constants) {
    std::map<std::string, Sampler> samplers;
    for (const Input& input : pass.inputs)
        samplers[input.uniform] = input.sampler;
    auto program = translate_to_es(pass.vertex, pass.fragment, samplers, constants);
    if (program)
        return program;
    Diagnostics problems = program.error();
    for (Diagnostic& problem : problems)
        problem.message = fmt::format("pass '{}': {}", pass.name, problem.message);
    return fail(std::move(problems));
}

// Whether all its passes define the constant in a way that a page can change.
bool is_changeable(const Look& look, const Parameter& parameter) {
    return parameter.is_constant && !parameter.bindings.empty() &&
           std::ranges::all_of(parameter.bindings, [&](const Binding& binding) {
               const Pass& pass = look.passes[static_cast<std::size_t>(binding.pass)];
               const auto defines = [&](const Stage& stage) {
                   return can_be_specialized(stage.text, parameter.name);
               };
               const auto names = [&](const Stage& stage) {
                   return std::string_view(stage.text).find(parameter.name) != std::string::npos;
               };
               return (defines(pass.vertex) || defines(pass.fragment)) &&
                      (defines(pass.vertex) || !names(pass.vertex)) &&
                      (defines(pass.fragment) || !names(pass.fragment));
           });
}

std::vector<EsConstant> changeable_constants(const Look& look) {
    std::vector<EsConstant> constants;
    for (std::size_t i = 0; i < look.parameters.size(); ++i)
        if (is_changeable(look, look.parameters[i]))
            constants.push_back({look.parameters[i].name, static_cast<int>(i)});
    return constants;
}

// Without the constants that prevent the translation of a pass, such as the label of a case.
std::vector<EsConstant> usable_constants(const Look& look) {
    std::vector<EsConstant> usable;
    for (const EsConstant& constant : changeable_constants(look)) {
        usable.push_back(constant);
        const Parameter& parameter = look.parameters[static_cast<std::size_t>(constant.id)];
        if (!std::ranges::all_of(parameter.bindings, [&](const Binding& binding) {
                return translated(look.passes[static_cast<std::size_t>(binding.pass)], usable)
                    .has_value();
            }))
            usable.pop_back();
    }
    return usable;
}

// Samplers in the declarations "uniform highp sampler2D name;" of a compact text.
std::size_t samplers_in(std::string_view text) {
    constexpr std::string_view declared = "uniform highp ";
    std::size_t count = 0;
    for (std::size_t at = text.find(declared); at != text.npos; at = text.find(declared, at)) {
        at += declared.size();
        const std::string_view type = text.substr(at, text.find(' ', at) - at);
        count += type.find("sampler") != type.npos ? 1 : 0;
    }
    return count;
}
}  // namespace

std::size_t pictures_read(const EsShaders& shaders, std::size_t pass) {
    const auto [vertex, fragment] = shaders.passes[pass];
    return samplers_in(shaders.texts[vertex]) + samplers_in(shaders.texts[fragment]);
}

Result<EsShaders> es_shaders(const Look& look) {
    EsShaders shaders;
    shaders.constants = usable_constants(look);
    for (const Pass& pass : look.passes) {
        auto program = translated(pass, shaders.constants);
        if (!program)
            return fail(program.error());
        const std::size_t vertex = index_of(compact_glsl(program->vertex), shaders.texts);
        shaders.passes.emplace_back(vertex,
                                    index_of(compact_glsl(program->fragment), shaders.texts));
    }
    return shaders;
}
