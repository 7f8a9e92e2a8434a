#include "parity/parsed_chain.h"

#include <map>

Result<ParsedChain> parse_chain(const std::filesystem::path& file) {
    ParsedChain chain;
    SlangFiles files;
    auto preset = read_slang_preset(file, files);
    if (!preset)
        return fail(preset.error());
    chain.preset = std::move(*preset);
    std::map<std::filesystem::path, std::size_t> first_with;
    for (std::size_t i = 0; i < chain.preset.passes.size(); ++i) {
        const auto [same, is_new] = first_with.emplace(chain.preset.passes[i].shader, i);
        if (!is_new) {
            SlangShader shader = chain.shaders[same->second];
            Translation translation = chain.translations[same->second];
            chain.shaders.push_back(std::move(shader));
            chain.translations.push_back(std::move(translation));
            continue;
        }
        auto shader = read_slang_shader(chain.preset.passes[i].shader, files);
        if (!shader)
            return fail(shader.error());
        auto translation = translate_from_vulkan(shader->vertex, shader->fragment);
        if (!translation)
            return fail(translation.error());
        chain.shaders.push_back(std::move(*shader));
        chain.translations.push_back(std::move(*translation));
    }
    return chain;
}
