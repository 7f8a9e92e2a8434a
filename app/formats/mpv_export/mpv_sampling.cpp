#include "formats/mpv_export/mpv_sampling.h"

#include "formats/mpv_export/mpv_functions.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
// The functions of GLSL that read textures.
constexpr const char* replaced[] = {"texture",     "textureLod",       "textureGrad",
                                    "textureSize", "textureOffset",    "textureLodOffset",
                                    "texelFetch",  "texelFetchOffset", "textureGather"};

const char* filter_name(Filter filter) {
    return filter == Filter::linear ? "linear" : "nearest";
}

const char* wrap_name(Wrap wrap) {
    switch (wrap) {
        case Wrap::border:
            return "border";
        case Wrap::repeat:
            return "repeat";
        case Wrap::mirror:
            return "mirror";
        default:
            return "edge";
    }
}

/// Writes functions that take the number of an input.
class NumberedSamplers {
public:
    NumberedSamplers(const EffectUniforms& uniforms, const MpvTextures& textures)
        : m_uniforms(uniforms), m_textures(textures), m_functions(mpv_rounding_functions()) {
        add(mpv_reader_functions());
        for (std::size_t i = 0; i < inputs().size(); ++i)
            if (m_textures.levels_of(inputs()[i]) > 0)
                add({{fmt::format("afterglow_levels_{}", i), level_function(i)}});
        add({{"afterglow_read", read_function()},
             {"afterglow_texel", texel_function()},
             {"afterglow_texelFetch", fetch_function()},
             {"afterglow_size", size_function()},
             {"afterglow_level_at", level_at_function()}});
        add(mpv_numbered_functions());
    }

    MpvSampling write(const GlslWords& words) const {
        MpvSampling sampling;
        std::set<std::string> wanted;
        std::size_t number = 0;
        const auto add_input = [&](const std::string& uniform) {
            const std::string name = fmt::format("{}input_{}", mpv_prefix, uniform);
            sampling.declarations += fmt::format("const int {} = {};\n", name, number++);
            sampling.macros.emplace_back(uniform, name);
        };
        for (const Input& input : inputs())
            add_input(input.uniform);
        for (const std::string& uniform : m_uniforms.unread)
            add_input(uniform);
        if (words.contains("sampler2D"))
            sampling.macros.emplace_back("sampler2D", "int");
        for (const char* name : replaced) {
            if (!words.contains(name))
                continue;
            sampling.macros.emplace_back(name, mpv_prefix + std::string(name));
            wanted.insert(sampling.macros.back().second);
        }
        sampling.declarations += mpv_function_text(m_functions, wanted);
        return sampling;
    }

private:
    const std::vector<Input>& inputs() const { return m_uniforms.samplers; }

    void add(const std::vector<MpvFunction>& functions) {
        m_functions.insert(m_functions.end(), functions.begin(), functions.end());
    }

    // One level of an input. 8-bit numbers are restored where no filter mixes them.
    std::string level_text(const Input& input, int level, Filter filter) const {
        const std::string sampler = level == 0 ? m_textures.sampler_of(input)
                                               : m_textures.level_name(input, level) + "_raw";
        const std::string text = fmt::format("afterglow_{}_{}({}, at)", filter_name(filter),
                                             wrap_name(input.sampler.wrap), sampler);
        return exact(input, level, filter, text);
    }

    std::string exact(const Input& input, int level, Filter filter, const std::string& text) const {
        return level == 0 && filter == Filter::nearest && m_textures.is_bytes(input)
                   ? fmt::format("afterglow_rounded({})", text)
                   : text;
    }

    std::string level_function(std::size_t i) const {
        const Input& input = inputs()[i];
        const int last = m_textures.levels_of(input);
        std::string text = fmt::format("vec4 afterglow_level_{}(vec2 at, int level) {{\n", i);
        for (int level = 0; level < last; ++level)
            text += fmt::format("    if (level <= {}) return {};\n", level,
                                level_text(input, level, input.sampler.filter));
        text += fmt::format("    return {};\n}}\n", level_text(input, last, input.sampler.filter));
        const bool mixes =
            input.sampler.between_levels.value_or(input.sampler.filter) == Filter::linear;
        text += fmt::format(
            "vec4 afterglow_levels_{}(vec2 at, float level) {{\n    level = clamp(level, 0.0, "
            "{}.0);\n",
            i, last);
        if (!mixes)
            return text +
                   fmt::format("    return afterglow_level_{}(at, int(floor(level + 0.5)));\n}}\n",
                               i);
        return text + fmt::format(
                          "    int lower = int(floor(level));\n    float part = fract(level);\n"
                          "    vec4 texel = afterglow_level_{0}(at, lower);\n"
                          "    return part > 0.0 ? mix(texel, afterglow_level_{0}(at, lower + 1), "
                          "part) : texel;\n}}\n",
                          i);
    }

    // A function that chooses by the number of the input. `of`: the expression for one.
    template <class Expression>
    std::string choice(const std::string& head, const std::string& otherwise, Expression of) const {
        std::string text = head + " {\n";
        for (std::size_t i = 0; i < inputs().size(); ++i)
            text += fmt::format("    if (image == {}) return {};\n", i, of(inputs()[i], i));
        return text + fmt::format("    return {};\n}}\n", otherwise);
    }

    std::string read_function() const {
        return choice("vec4 afterglow_read(int image, vec2 at, float level)", "vec4(0.0)",
                      [&](const Input& input, std::size_t i) {
                          return m_textures.levels_of(input) > 0
                                     ? fmt::format("afterglow_levels_{}(at, level)", i)
                                     : level_text(input, 0, input.sampler.filter);
                      });
    }

    std::string texel_function() const {
        return choice(
            "vec4 afterglow_texel(int image, vec2 at)", "vec4(0.0)",
            [&](const Input& input, std::size_t) { return level_text(input, 0, Filter::nearest); });
    }

    std::string fetch_function() const {
        return choice(
            "vec4 afterglow_texelFetch(int image, ivec2 texel, int level)", "vec4(0.0)",
            [&](const Input& input, std::size_t) {
                std::string text;
                for (int level = m_textures.levels_of(input); level > 0; --level)
                    text += fmt::format("level == {} ? texelFetch({}_raw, texel, 0) : ", level,
                                        m_textures.level_name(input, level));
                return text +
                       exact(input, 0, Filter::nearest,
                             fmt::format("texelFetch({}, texel, 0)", m_textures.sampler_of(input)));
            });
    }

    // The level that the graphics card would choose. It is the same for a texture without levels.
    std::string level_at_function() const {
        return choice("float afterglow_level_at(int image, vec2 at)", "0.0",
                      [&](const Input& input, std::size_t) {
                          return m_textures.levels_of(input) > 0
                                     ? fmt::format("textureQueryLod({}, at).y",
                                                   m_textures.sampler_of(input))
                                     : std::string("0.0");
                      });
    }

    std::string size_function() const {
        return choice("ivec2 afterglow_size(int image)", "ivec2(1)",
                      [&](const Input& input, std::size_t) {
                          return fmt::format("textureSize({}, 0)", m_textures.sampler_of(input));
                      });
    }

    const EffectUniforms& m_uniforms;
    const MpvTextures& m_textures;
    std::vector<MpvFunction> m_functions;  // each after those that it calls
};
}  // namespace

MpvSampling mpv_sampling(const EffectUniforms& uniforms, const MpvTextures& textures,
                         const GlslWords& words) {
    const bool reads_texels = words.contains("texelFetch") || words.contains("texelFetchOffset") ||
                              words.contains("textureGather");
    const auto is_plain = [&](const Input& input) {
        return input.sampler == Sampler{} && !(reads_texels && textures.is_bytes(input));
    };
    if (!uniforms.unread.empty() || !std::ranges::all_of(uniforms.samplers, is_plain))
        return NumberedSamplers(uniforms, textures).write(words);
    MpvSampling sampling;
    for (const Input& input : uniforms.samplers)
        sampling.macros.emplace_back(input.uniform, textures.sampler_of(input));
    return sampling;
}
