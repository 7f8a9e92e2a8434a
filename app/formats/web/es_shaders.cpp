#include "formats/web/es_shaders.h"

#include "formats/web/compact_glsl.h"
#include "glsl/es/es_program.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
std::size_t index_of(std::string text, std::vector<std::string>& texts) {
    const auto found = std::ranges::find(texts, text);
    if (found != texts.end())
        return static_cast<std::size_t>(found - texts.begin());
    texts.push_back(std::move(text));
    return texts.size() - 1;
}
}  // namespace

Result<EsShaders> es_shaders(const Look& look) {
    EsShaders shaders;
    for (const Pass& pass : look.passes) {
        std::map<std::string, Sampler> samplers;
        for (const Input& input : pass.inputs)
            samplers[input.uniform] = input.sampler;
        auto program = translate_to_es(pass.vertex, pass.fragment, samplers);
        if (!program) {
            Diagnostics problems = program.error();
            for (Diagnostic& problem : problems)
                problem.message = fmt::format("pass '{}': {}", pass.name, problem.message);
            return fail(std::move(problems));
        }
        const std::size_t vertex = index_of(compact_glsl(program->vertex), shaders.texts);
        shaders.passes.emplace_back(vertex,
                                    index_of(compact_glsl(program->fragment), shaders.texts));
    }
    return shaders;
}
