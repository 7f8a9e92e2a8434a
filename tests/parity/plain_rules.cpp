#include "parity/plain_rules.h"

#include <algorithm>
#include <cmath>

namespace plain {

namespace {
using Of = Read::Of;

int count_of(const ParsedChain& chain) {
    return static_cast<int>(chain.preset.passes.size());
}

const SlangPass& pass_of(const ParsedChain& chain, int pass) {
    return chain.preset.passes[static_cast<std::size_t>(pass)];
}

std::string alias_of(const ParsedChain& chain, int pass) {
    const std::string& preset = pass_of(chain, pass).alias;
    return preset.empty() ? chain.shaders[static_cast<std::size_t>(pass)].alias : preset;
}

// The state of a texture that belongs to `pass`.
State pass_state(const ParsedChain& chain, int pass, bool has_levels) {
    State state;
    if (pass >= count_of(chain))
        return state;
    const SlangPass& declared = pass_of(chain, pass);
    state.is_linear = declared.is_linear.value_or(false);
    state.wrap = declared.wrap;
    state.has_levels = has_levels;
    state.is_linear_between_levels =
        has_levels && declared.is_linear.value_or(true) && plain::has_levels(chain, pass);
    return state;
}

template <class Act>
void for_each_sampler(const ParsedChain& chain, const Names& names, Act act) {
    for (const Translation& translation : chain.translations)
        for (const NamedSampler& sampler : translation.samplers)
            if (const auto read = names.textures.find(sampler.name); read != names.textures.end())
                act(read->second);
}

int side_of(const SlangScale& scale, int source, int original, int viewport) {
    const auto factor = static_cast<float>(scale.factor);
    switch (scale.by) {
        case SlangScale::By::absolute:
            return std::max(1, static_cast<int>(scale.factor));
        case SlangScale::By::viewport:
            source = viewport;
            break;
        case SlangScale::By::original:
            source = original;
            break;
        case SlangScale::By::source:
            break;
    }
    return std::max(1, static_cast<int>(std::round(static_cast<float>(source) * factor)));
}
}  // namespace

Names names_of(const ParsedChain& chain) {
    constexpr int max_history = 128;
    Names names;
    const auto add = [&names](const std::string& texture, const std::string& size, Read read) {
        names.textures.emplace(texture, read);
        names.sizes.emplace(size, read);
    };
    for (int i = 0; i < count_of(chain); ++i)
        if (const std::string alias = alias_of(chain, i); !alias.empty()) {
            add(alias, alias + "Size", {Of::output, i});
            add(alias + "Feedback", alias + "FeedbackSize", {Of::feedback, i});
        }
    for (int i = 0; i < static_cast<int>(chain.preset.textures.size()); ++i) {
        const std::string& id = chain.preset.textures[static_cast<std::size_t>(i)].name;
        add(id, id + "Size", {Of::lut, i});
        add("User" + std::to_string(i), "UserSize" + std::to_string(i), {Of::lut, i});
    }
    add("Original", "OriginalSize", {Of::history, 0});
    add("Source", "SourceSize", {Of::source, 0});
    for (int i = 0; i <= max_history; ++i)
        add("OriginalHistory" + std::to_string(i), "OriginalHistorySize" + std::to_string(i),
            {Of::history, i});
    for (int i = 0; i < count_of(chain); ++i) {
        add("PassOutput" + std::to_string(i), "PassOutputSize" + std::to_string(i),
            {Of::output, i});
        add("PassFeedback" + std::to_string(i), "PassFeedbackSize" + std::to_string(i),
            {Of::feedback, i});
    }
    return names;
}

bool ends_with_copy(const ParsedChain& chain) {
    return chain.preset.passes.back().scale.has_value();
}

bool has_levels(const ParsedChain& chain, int pass) {
    return pass >= 0 && pass + 1 < count_of(chain) && pass_of(chain, pass + 1).reads_mipmaps;
}

State state_of(const ParsedChain& chain, const Read& read, int reader) {
    switch (read.of) {
        case Of::history:
            return pass_state(chain, 0, false);
        case Of::source:
            return pass_state(chain, reader, has_levels(chain, reader - 1));
        case Of::output:
            return pass_state(chain, read.number + 1, has_levels(chain, read.number));
        case Of::feedback:
            return pass_state(chain, read.number, has_levels(chain, read.number));
        case Of::lut:
            break;
    }
    const SlangTexture& lut = chain.preset.textures[static_cast<std::size_t>(read.number)];
    const bool is_linear = lut.is_linear.value_or(true);
    return {is_linear, is_linear && lut.is_mipmapped, lut.wrap, lut.is_mipmapped};
}

GLenum format_of(const ParsedChain& chain, int pass) {
    static const std::map<std::string, GLenum> formats{{"R8_UNORM", GL_R8},
                                                       {"R8G8_UNORM", GL_RG8},
                                                       {"R8G8B8A8_SRGB", GL_SRGB8_ALPHA8},
                                                       {"A2B10G10R10_UNORM_PACK32", GL_RGB10_A2},
                                                       {"R16_SFLOAT", GL_R16F},
                                                       {"R16G16_SFLOAT", GL_RG16F},
                                                       {"R16G16B16A16_SFLOAT", GL_RGBA16F},
                                                       {"R32_SFLOAT", GL_R32F},
                                                       {"R32G32_SFLOAT", GL_RG32F},
                                                       {"R32G32B32A32_SFLOAT", GL_RGBA32F},
                                                       {"R32_UINT", GL_R32UI},
                                                       {"R8G8B8A8_SINT", GL_RGBA8I},
                                                       {"R16_SINT", GL_R16I},
                                                       {"R32G32B32A32_SINT", GL_RGBA32I}};
    const bool is_shown = pass + 1 == count_of(chain) && !ends_with_copy(chain);
    if (pass >= count_of(chain) || is_shown)
        return GL_RGBA8;
    const SlangPass& declared = pass_of(chain, pass);
    if (declared.scale && declared.is_srgb)
        return GL_SRGB8_ALPHA8;
    if (declared.scale && declared.is_float)
        return GL_RGBA16F;
    const auto found = formats.find(chain.shaders[static_cast<std::size_t>(pass)].format);
    return found == formats.end() ? GL_RGBA8 : found->second;
}

std::vector<Extent> sizes_of(const ParsedChain& chain, Extent original, Extent viewport) {
    std::vector<Extent> sizes;
    Extent source = original;
    for (const SlangPass& pass : chain.preset.passes) {
        if (pass.scale)
            source = {side_of((*pass.scale)[0], source.width, original.width, viewport.width),
                      side_of((*pass.scale)[1], source.height, original.height, viewport.height)};
        else if (&pass == &chain.preset.passes.back())
            source = viewport;
        sizes.push_back(source);
    }
    if (ends_with_copy(chain))
        sizes.push_back(viewport);
    return sizes;
}

int history_of(const ParsedChain& chain, const Names& names) {
    int maximum = 0;
    for_each_sampler(chain, names, [&](const Read& read) {
        if (read.of == Of::history)
            maximum = std::max(maximum, read.number);
    });
    return maximum;
}

bool has_feedback(const ParsedChain& chain, const Names& names, int pass) {
    bool is_read = false;
    for_each_sampler(chain, names, [&](const Read& read) {
        is_read = is_read || read == Read{Of::feedback, pass};
    });
    return is_read;
}

std::optional<double> parameter_of(const ParsedChain& chain, const std::string& name) {
    for (const SlangShader& shader : chain.shaders)
        for (const auto& parameter : shader.parameters)
            if (parameter->id == name) {
                const auto set = chain.preset.values.find(name);
                return set == chain.preset.values.end() ? parameter->initial : set->second.number;
            }
    return std::nullopt;
}

}  // namespace plain
