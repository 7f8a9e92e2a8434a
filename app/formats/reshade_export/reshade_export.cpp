#include "formats/reshade_export/reshade_export.h"

#include "formats/glsl/modern_glsl.h"
#include "formats/reshade_export/fx_shader.h"
#include "formats/reshade_export/fx_text.h"
#include "formats/reshade_export/reshade_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
constexpr std::size_t most_samplers = 32;  // of an effect in vkBasalt

// ReShade shows them as settings of the effect.
constexpr const char* settings = R"(
// Settings. ReShade shows them with the effect. For vkBasalt, change them here.
#ifndef AFTERGLOW_SOURCE_LINES
    #define AFTERGLOW_SOURCE_LINES 240  // lines of the game's picture; 0: all lines of the screen
#endif
#ifndef AFTERGLOW_SOURCE_COLUMNS
    #define AFTERGLOW_SOURCE_COLUMNS 0  // its width in pixels; 0: by the shape of the picture
#endif
#ifndef AFTERGLOW_CONTENT_LEFT
    #define AFTERGLOW_CONTENT_LEFT 0  // the part of the screen with the picture, in pixels
#endif
#ifndef AFTERGLOW_CONTENT_TOP
    #define AFTERGLOW_CONTENT_TOP 0
#endif
#ifndef AFTERGLOW_CONTENT_WIDTH
    #define AFTERGLOW_CONTENT_WIDTH 0  // 0: that of the screen
#endif
#ifndef AFTERGLOW_CONTENT_HEIGHT
    #define AFTERGLOW_CONTENT_HEIGHT 0
#endif
#ifndef AFTERGLOW_FRAME_RATE
    #define AFTERGLOW_FRAME_RATE 0  // frames per second; 0: measured
#endif
)";

constexpr const char* functions = R"(
void afterglow_triangle(uint id : SV_VertexID, out float4 position : SV_Position,
                        out float2 place : TEXCOORD)
{
    place.x = (id == 2) ? 2.0 : 0.0;
    place.y = (id == 1) ? 2.0 : 0.0;
    position = float4(place * float2(2.0, -2.0) + float2(-1.0, 1.0), 0.0, 1.0);
}
float2 afterglow_upright(float2 place)
{
    return float2(place.x, 1.0 - place.y);
}
float2 afterglow_content(float2 place)
{
#if AFTERGLOW_CONTENT_WIDTH > 0 || AFTERGLOW_CONTENT_HEIGHT > 0
    return (place * float2(afterglow_width, afterglow_height) +
            float2(AFTERGLOW_CONTENT_LEFT, AFTERGLOW_CONTENT_TOP)) /
           float2(BUFFER_WIDTH, BUFFER_HEIGHT);
#else
    return place;
#endif
}
)";

// The picture in its part of the screen, and the game around it.
constexpr const char* part_of_screen = R"(
#if AFTERGLOW_CONTENT_WIDTH > 0 || AFTERGLOW_CONTENT_HEIGHT > 0
texture2D {0} {{ Width = afterglow_width; Height = afterglow_height; Format = RGBA8; }};
sampler2D afterglow_drawn {{ Texture = {0}; MinFilter = POINT; MagFilter = POINT; }};
sampler2D afterglow_around {{ Texture = afterglow_screen; MinFilter = POINT; MagFilter = POINT; }};
float4 afterglow_compose(float4 position : SV_Position, float2 place : TEXCOORD) : SV_Target
{{
    float2 size = float2(afterglow_width, afterglow_height);
    float2 inside = (position.xy - float2(AFTERGLOW_CONTENT_LEFT, AFTERGLOW_CONTENT_TOP)) / size;
    float4 around = tex2Dlod(afterglow_around, float4(place, 0.0, 0.0));
    float4 drawn = tex2Dlod(afterglow_drawn, float4(inside, 0.0, 0.0));
    bool is_inside = inside.x >= 0.0 && inside.y >= 0.0 && inside.x < 1.0 && inside.y < 1.0;
    return is_inside ? drawn : around;
}}
#endif
)";

bool has_8_bits(const Picture& picture) {
    constexpr float largest = 255.0f;
    return std::ranges::all_of(picture.pixels, [](float value) {
        return std::abs(value * largest - std::round(value * largest)) < 1e-3f;
    });
}

/// Writes the files of one look.
class ReshadeWriter {
public:
    ReshadeWriter(const EffectRequest& request, Effect effect)
        : m_request(request),
          m_effect(std::move(effect)),
          m_id(identifier_from(request.name)),
          m_folder(request.name + "_reshade") {
        m_output.losses = m_effect.losses;
    }

    Result<EffectOutput> write() {
        if (auto added = add_pictures(); !added)
            return fail(added.error());
        if (auto added = add_controls(); !added)
            return fail(added.error());
        FxTextures textures(look(), m_pictures, technique() + "_");
        FxShared shared{look(), textures, m_controls};
        for (std::size_t i = 0; i < look().passes.size(); ++i) {
            auto shader = fx_shader(i, m_uniforms[i], shared);
            if (!shader)
                return fail(shader.error());
            m_shaders += shader->text;
            add_pass(shader->function, i + 1 < look().passes.size() ? textures.target(i) : "",
                     look().passes[i].format);
        }
        add_copies(textures);
        if (textures.sampler_count() + 2 > most_samplers)
            return fail(
                {{},
                 0,
                 fmt::format("it reads textures in {} ways, of which vkBasalt can do {}. {}",
                             textures.sampler_count(), most_samplers - 2, fx_alternative)});
        m_output.texts[m_request.name + ".fx"] = effect_text(textures);
        add_settings();
        return std::move(m_output);
    }

private:
    const Look& look() const { return m_effect.look; }
    // Also the key of the effect for vkBasalt, so it must not be the name of a uniform.
    std::string technique() const { return "Afterglow_" + m_id; }

    Result<void> add_pictures() {
        auto pictures = effect_pictures(look(), m_folder, RowOrder::top_first, "");
        if (!pictures)
            return fail(pictures.error());
        m_pictures = std::move(*pictures);
        for (const EffectPicture& picture : m_pictures) {
            if (picture.file.extension != ".png" || !has_8_bits(picture.file.picture))
                return fail({{},
                             0,
                             fmt::format("the picture '{}' has more than 8 bits, which vkBasalt "
                                         "can't read. {}",
                                         picture.name, fx_alternative)});
            m_output.pictures[picture.path] = picture.file;
        }
        return {};
    }

    // Names of uniforms start with that of the effect, because all effects of vkBasalt share them.
    Result<void> add_controls() {
        EffectNames plain;
        EffectNames names(taken_names());
        for (EffectControl& control :
             effect_controls(look(), m_request.values, m_effect.fixed, plain)) {
            const std::string& parameter = control.parameter->name;
            if (!fits_fx(*control.parameter)) {
                m_effect.fixed.push_back(parameter);
                m_output.losses.push_back(
                    fmt::format("The control '{}'. ReShade has none for its type, so its value is "
                                "fixed.",
                                control.parameter->label));
                continue;
            }
            control.id = names.add(m_id + "_" + parameter);
            m_order.push_back(parameter);
            m_controls.emplace(parameter, fx_control(std::move(control)));
        }
        for (std::size_t i = 0; i < look().passes.size(); ++i) {
            auto uniforms = effect_uniforms(look(), i, m_request.values, m_effect.fixed);
            if (!uniforms)
                return fail(uniforms.error());
            m_uniforms.push_back(std::move(*uniforms));
        }
        return {};
    }

    // What a shader declares would hide a uniform of the same name.
    std::set<std::string, std::less<>> taken_names() const {
        std::set<std::string, std::less<>> taken{technique()};
        for (const Pass& pass : look().passes)
            for (const std::string_view text :
                 {std::string_view(pass.fragment.text), std::string_view(pass.vertex.text)}) {
                GlslWords words;
                add_words(text, words);
                taken.insert(words.begin(), words.end());
            }
        return taken;
    }

    void add_pass(const std::string& function, const std::string& target, Format format) {
        m_passes += fmt::format(
            "    pass\n    {{\n        VertexShader = afterglow_triangle;\n"
            "        PixelShader = {};\n",
            function);
        if (target.empty())
            m_passes += fmt::format(
                "#if AFTERGLOW_CONTENT_WIDTH > 0 || AFTERGLOW_CONTENT_HEIGHT > 0\n"
                "        RenderTarget = {0}_content;\n    }}\n"
                "    pass\n    {{\n        VertexShader = afterglow_triangle;\n"
                "        PixelShader = afterglow_compose;\n#endif\n",
                technique());
        else
            m_passes += fmt::format("        RenderTarget = {};\n", target);
        if (format == Format::srgb8_alpha8 && !target.empty())
            m_passes += "        SRGBWriteEnable = true;\n";
        m_passes += "    }\n";
    }

    void add_copies(FxTextures& textures) {
        std::size_t count = 0;
        for (const FxTextures::Copy& copy : textures.copies()) {
            const std::string name = fmt::format("afterglow_copy_{}", count++);
            m_shaders += fmt::format(
                "\nfloat4 {}(float4 position : SV_Position, float2 place : TEXCOORD) : SV_Target\n"
                "{{\n    return tex2Dlod({}, float4(place, 0.0, 0.0));\n}}\n",
                name, copy.sampler);
            add_pass(name, copy.target, copy.format);
        }
        if (textures.has_black()) {
            m_shaders +=
                "\nfloat4 afterglow_nothing(float4 position : SV_Position) : SV_Target\n"
                "{\n    return float4(0.0, 0.0, 0.0, 0.0);\n}\n";
            add_pass("afterglow_nothing", textures.black_target(), Format::rgba8);
        }
    }

    std::string effect_text(const FxTextures& textures) const {
        std::string text = notice_comment(m_request.look, m_request.notices);
        text += fmt::format("// Preset of ReShade: {}\n// Settings of vkBasalt: {}\n",
                            preset_path(), basalt_path());
        text += settings;
        text += fx_size_macros;
        text += "\n";
        for (const std::string& parameter : m_order)
            text += fx_declaration(m_controls.at(parameter), look());
        text += fx_built_ins(look(), textures) + "\n" + textures.declarations() + functions;
        text += fx_functions;
        text += fmt::format(fmt::runtime(part_of_screen), technique() + "_content");
        return text + m_shaders +
               fmt::format("\ntechnique {} < ui_label = {}; ui_tooltip = {}; >\n{{\n{}}}\n",
                           technique(), fx_string(m_request.look.name + " (Afterglow)"),
                           fx_string(m_request.look.about), m_passes);
    }

    void add_settings() {
        std::vector<FxControl> controls;
        for (const std::string& parameter : m_order)
            controls.push_back(m_controls.at(parameter));
        const ReshadeNames names{m_request.name + ".fx", technique(), m_request.folder};
        m_output.texts[preset_path()] = reshade_preset(names, controls);
        m_output.texts[basalt_path()] = vkbasalt_settings(names, controls);
    }

    std::string preset_path() const { return fmt::format("{}/{}.ini", m_folder, m_request.name); }
    std::string basalt_path() const { return m_folder + "/vkBasalt.conf"; }

    const EffectRequest& m_request;
    Effect m_effect;
    std::string m_id;      // the name as an identifier
    std::string m_folder;  // of the other files
    std::vector<EffectPicture> m_pictures;
    std::map<std::string, FxControl> m_controls;  // by parameter
    std::vector<std::string> m_order;             // of the parameters
    std::vector<EffectUniforms> m_uniforms;       // of each pass
    std::string m_shaders;
    std::string m_passes;
    EffectOutput m_output;
};
}  // namespace

const EffectHost& reshade_host() {
    static const EffectHost host{
        .name = "ReShade", .most_frames_ago = 8, .has_integers = false, .is_on_screen = true};
    return host;
}

Result<EffectOutput> reshade_files(const EffectRequest& request) {
    const std::string path = (request.folder / request.name).string();
    if (path.find_first_of("\"\\\n") != path.npos)
        return fail({path, 0,
                     "has a quote, a backslash or a line end, which vkBasalt can't read in a path. "
                     "Choose another name."});
    auto effect =
        effect_of(request.look, request.values, request.size, request.source, reshade_host());
    if (!effect)
        return fail(effect.error());
    return ReshadeWriter(request, std::move(*effect)).write();
}
