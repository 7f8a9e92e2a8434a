#include "formats/shadertoy/shadertoy_stage.h"

#include "base/text.h"
#include "glsl/text/declarations.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace {
using Kind = ShadertoyPass::Kind;

std::string_view sampler_type(PictureShape shape) {
    switch (shape) {
        case PictureShape::cube:
            return "samplerCube";
        case PictureShape::volume:
            return "sampler3D";
        case PictureShape::flat:
            break;
    }
    return "sampler2D";
}

/// Assembles the parts of a stage.
class ShadertoyStage {
public:
    ShadertoyStage(const ShadertoyPass& pass, const ShadertoyPass* common)
        : m_pass(pass), m_words(shadertoy_words(pass, common)) {
        m_stage.file = pass.code.file;
        for (const ShadertoyPass* part : {common, &pass})
            if (part)
                for (const Declaration& declaration : find_declarations(part->code.text))
                    m_declared.insert(declaration.name);
    }

    Stage stage(const ShadertoyPass* common, const ShadertoyChannels& channels) {
        add_own(modern_glsl_start(m_words));
        add_own("#define HW_PERFORMANCE 1\n");
        add_uniforms(channels);
        add_arrays(channels);
        add_own("out vec4 afterglow_output;\n");
        if (common)
            add_code(common->code);
        add_code(m_pass.code);
        add_own(main_of(m_pass.kind));
        return std::move(m_stage);
    }

private:
    bool has(std::string_view word) const { return m_words.contains(word); }

    void add_own(std::string_view text) {
        m_stage.text.own() += text;
        m_stage.lines.append({{}, 1}, static_cast<std::size_t>(std::ranges::count(text, '\n')));
    }

    void declare(std::string_view type, const std::string& name) {
        if (!m_declared.contains(name))
            add_own(fmt::format("uniform {} {};\n", type, name));
    }

    void declare_if_meant(std::string_view type, const std::string& name) {
        if (has(name))
            declare(type, name);
    }

    void add_uniforms(const ShadertoyChannels& channels) {
        if (has("iResolution") || m_pass.kind == Kind::cube)
            declare("vec3", "iResolution");
        const bool needs_time = has("iTime") || has("iChannelTime") || has_channel_struct();
        if (needs_time)
            declare("float", "iTime");
        for (const char* name : {"iGlobalTime", "iTimeDelta", "iFrameRate", "iSampleRate"})
            declare_if_meant("float", name);
        declare_if_meant("int", "iFrame");
        declare_if_meant("vec4", "iMouse");
        declare_if_meant("vec4", "iDate");
        for (int channel = 0; channel < shadertoy_channels; ++channel) {
            const ShadertoyChannel& fed = channels[static_cast<std::size_t>(channel)];
            const std::string name = fmt::format("iChannel{}", channel);
            if (fed.is_connected || has(name) || has(fmt::format("iCh{}", channel)))
                declare(sampler_type(fed.shape), name);
        }
    }

    bool has_channel_struct() const {
        return has("iCh0") || has("iCh1") || has("iCh2") || has("iCh3");
    }

    void add_resolutions(const ShadertoyChannels& channels) {
        std::vector<std::string> all;
        for (std::size_t channel = 0; channel < channels.size(); ++channel) {
            const std::string name = fmt::format("afterglow_resolution{}", channel);
            const bool is_volume = channels[channel].shape == PictureShape::volume;
            if (channels[channel].is_connected && !is_volume)
                declare("vec3", name);
            all.push_back(!channels[channel].is_connected ? "vec3(0.0)"
                          : is_volume ? fmt::format("vec3(textureSize(iChannel{}, 0))", channel)
                                      : name);
        }
        add_own(fmt::format("vec3 iChannelResolution[4] = vec3[4]({});\n", fmt::join(all, ", ")));
    }

    void add_arrays(const ShadertoyChannels& channels) {
        const bool has_structs = has_channel_struct();
        if (has("iChannelResolution") || has_structs)
            add_resolutions(channels);
        if (has("iChannelTime"))
            add_own("float iChannelTime[4] = float[4](iTime, iTime, iTime, iTime);\n");
        if (has_structs)
            add_own("struct AfterglowChannel { vec3 size; float time; int loaded; };\n");
        for (int channel = 0; channel < shadertoy_channels; ++channel)
            if (has(fmt::format("iCh{}", channel)))
                add_own(
                    fmt::format("AfterglowChannel iCh{0} = "
                                "AfterglowChannel(iChannelResolution[{0}], iTime, 1);\n",
                                channel));
    }

    void add_code(const Stage& code) {
        std::string text = modern_glsl(code.text);
        for (int channel = 0; channel < shadertoy_channels; ++channel)
            text = replace_all(text, fmt::format("iCh{}.sampler", channel),
                               fmt::format("iChannel{}", channel));
        const std::size_t lines = split_lines(text).size();
        if (!text.empty() && !text.ends_with('\n'))
            text += '\n';
        m_stage.text.own() += text;
        for (std::size_t line = 0; line < lines; ++line)
            m_stage.lines.push_back(origin_of(code.lines, static_cast<int>(line) + 1));
    }

    // As on the site, a missing output is conspicuous and the picture is opaque.
    static std::string_view main_of(Kind kind) {
        if (kind == Kind::cube)
            return "void main() {\n"
                   "    float side = iResolution.y;\n"
                   "    int face = int(gl_FragCoord.x / side);\n"
                   "    vec2 place = vec2(gl_FragCoord.x - side * float(face), gl_FragCoord.y);\n"
                   "    vec2 at = place / side * 2.0 - 1.0;\n"
                   "    vec3 seen = face == 0   ? vec3(1.0, -at.y, -at.x)\n"
                   "                : face == 1 ? vec3(-1.0, -at.y, at.x)\n"
                   "                : face == 2 ? vec3(at.x, 1.0, at.y)\n"
                   "                : face == 3 ? vec3(at.x, -1.0, -at.y)\n"
                   "                : face == 4 ? vec3(at.x, -at.y, 1.0)\n"
                   "                            : vec3(-at.x, -at.y, -1.0);\n"
                   "    vec4 color = vec4(1e20);\n"
                   "    mainCubemap(color, place, vec3(0.0), normalize(seen));\n"
                   "    afterglow_output = color;\n"
                   "}\n";
        if (kind == Kind::image)
            return "void main() {\n"
                   "    vec4 color = vec4(1e20);\n"
                   "    mainImage(color, gl_FragCoord.xy);\n"
                   "    afterglow_output = vec4(color.rgb, 1.0);\n"
                   "}\n";
        return "void main() {\n"
               "    vec4 color = vec4(1e20);\n"
               "    mainImage(color, gl_FragCoord.xy);\n"
               "    afterglow_output = color;\n"
               "}\n";
    }

    const ShadertoyPass& m_pass;
    GlslWords m_words;
    std::set<std::string, std::less<>> m_declared;
    Stage m_stage;
};
}  // namespace

Stage shadertoy_fragment_stage(const ShadertoyPass& pass, const ShadertoyPass* common,
                               const ShadertoyChannels& channels) {
    return ShadertoyStage(pass, common).stage(common, channels);
}

void suggest_shadertoy_inputs(Diagnostics& problems) {
    static const std::vector<std::string> inputs{
        "iResolution",        "iTime",        "iTimeDelta", "iFrame",    "iFrameRate",
        "iChannelResolution", "iChannelTime", "iMouse",     "iDate",     "iSampleRate",
        "iChannel0",          "iChannel1",    "iChannel2",  "iChannel3",
    };
    constexpr std::string_view end = "' is undeclared";
    for (Diagnostic& problem : problems) {
        if (!problem.message.ends_with(end))
            continue;
        const std::string_view before =
            std::string_view(problem.message).substr(0, problem.message.size() - end.size());
        const std::string_view name = before.substr(before.rfind('\'') + 1);
        if (name.size() > 3)
            problem.message += did_you_mean(name, inputs);
    }
}

std::vector<BuiltInUniform> shadertoy_built_ins(const std::vector<Input>& inputs,
                                                const Stage& fragment) {
    std::vector<BuiltInUniform> all{{"iResolution", BuiltIn::target_resolution},
                                    {"iTime", BuiltIn::time_before},
                                    {"iGlobalTime", BuiltIn::time_before},
                                    {"iTimeDelta", BuiltIn::time_delta},
                                    {"iFrameRate", BuiltIn::frame_rate},
                                    {"iFrame", BuiltIn::frame_index},
                                    {"iMouse", BuiltIn::press},
                                    {"iDate", BuiltIn::date_from_0}};
    for (int channel = 0; channel < shadertoy_channels; ++channel) {
        const auto input =
            std::ranges::find(inputs, fmt::format("iChannel{}", channel), &Input::uniform);
        const std::string name = fmt::format("afterglow_resolution{}", channel);
        if (input != inputs.end())
            all.push_back({name, BuiltIn::input_resolution, *input});
    }
    std::set<std::string> declared;
    for (const Declaration& declaration : find_declarations(fragment.text))
        declared.insert(declaration.name);
    std::erase_if(
        all, [&](const BuiltInUniform& built_in) { return !declared.contains(built_in.name); });
    return all;
}

GlslWords shadertoy_words(const ShadertoyPass& pass, const ShadertoyPass* common) {
    GlslWords words;
    add_words(pass.code.text, words);
    if (common)
        add_words(common->code.text, words);
    return words;
}
