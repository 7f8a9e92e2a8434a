// Chains of libretro's shaders drawn by the program, compared with a plain chain of the GL calls
// that RetroArch's rules require, rule by rule.
#include "io/pictures/picture_file.h"
#include "io/temporary_folder.h"
#include "lab/export/export_target.h"
#include "lab/offline/corpus.h"
#include "lab/offline/prepared_look.h"
#include "parity/moving_picture.h"
#include "parity/pair.h"
#include "problems_of.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>

namespace {
constexpr const char* parity_head = R"(#version 450
layout(push_constant) uniform Push { vec4 SourceSize; vec4 OutputSize; uint FrameCount; } push;
layout(std140, set = 0, binding = 0) uniform UBO {
    mat4 MVP; vec4 OriginalSize; vec4 FinalViewportSize; float bright;
} u;
#pragma parameter bright "Bright" 0.5 0.0 1.0 0.01
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 at;
void main() { gl_Position = u.MVP * Position; at = TexCoord; }
#pragma stage fragment
layout(location = 0) in vec2 at;
)";

std::string shader_of(const std::string& color, const std::vector<std::string>& samplers,
                      const std::string& pragmas = "", const std::string& type = "vec4") {
    std::string text = parity_head + pragmas + "layout(location = 0) out " + type + " FragColor;\n";
    int binding = 1;
    for (const std::string& sampler : samplers)
        text += fmt::format("layout(set = 0, binding = {}) uniform {}sampler2D {};\n", ++binding,
                            sampler.starts_with("Whole")    ? "u"
                            : sampler.starts_with("Signed") ? "i"
                                                            : "",
                            sampler);
    return text + "void main() { FragColor = " + color + "; }\n";
}

// Slightly rotated, so that every filter, wrap mode and border has an effect.
constexpr const char* turned = "mat2(1.1, 0.13, -0.13, 1.1) * (at - 0.5) + 0.47";
const std::string reads_source = shader_of(fmt::format("texture(Source, {})", turned), {"Source"});
const std::string copies = shader_of("texture(Source, at)", {"Source"});

class ParityFolder {
public:
    std::filesystem::path preset(const std::vector<std::string>& shaders,
                                 const std::string& lines) const {
        std::string text = fmt::format("shaders = {}\n", shaders.size());
        for (std::size_t i = 0; i < shaders.size(); ++i) {
            m_folder.write(fmt::format("{}.slang", i), shaders[i]);
            text += fmt::format("shader{0} = {0}.slang\n", i);
        }
        return m_folder.write("a.slangp", text + lines);
    }
    /// Over six frames of a moving picture of 37 x 23 px in a view of 61 x 47 px.
    plain::Difference difference(const std::vector<std::string>& shaders,
                                 const std::string& lines) const {
        auto pair = plain::Pair::open(preset(shaders, lines), {37, 23}, {61, 47});
        REQUIRE_MESSAGE(pair.has_value(), problems_of(pair));
        const auto difference = pair->compare(6);
        REQUIRE(difference.has_value());
        return *difference;
    }
    void save_lut(const std::string& name) const {
        const plain::Bytes lut = plain::moving_picture({19, 11}, 3);
        REQUIRE(save_picture(plain::picture_of(lut), m_folder / name).has_value());
    }

private:
    TemporaryFolder m_folder;
};

// Rounding may differ by one 8-bit level; a wrong read differs by much more.
void check_same(const plain::Difference& difference) {
    CHECK(difference.mean <= 2e-4);
    CHECK(difference.largest <= 2.0 / 255.0);
}

void check_same(const std::vector<std::string>& shaders, const std::string& lines) {
    check_same(ParityFolder().difference(shaders, lines));
}
}  // namespace

TEST_CASE("parity: the last pass is scaled to the view, also at exact texel edges") {
    check_same({copies}, "scale_type0 = source\nscale0 = 2.0\n");
    check_same({reads_source},
               "scale_type_x0 = absolute\nscale_x0 = 122\nscale_type_y0 = viewport\n"
               "scale_y0 = 2.0\n");
}

TEST_CASE("parity: filter and wrap belong to the texture that is read") {
    const std::string two =
        shader_of(fmt::format("texture(Source, {0}) * 0.5 + texture(Original, {0}) * 0.3 +"
                              " texture(PassOutput0, {0}) * 0.2",
                              turned),
                  {"Source", "Original", "PassOutput0"});
    for (const char* wrap : {"clamp_to_border", "clamp_to_edge", "repeat", "mirrored_repeat"})
        for (const char* linear :
             {"filter_linear1 = true\n", "filter_linear0 = true\n", "filter_linear2 = true\n"})
            check_same({reads_source, copies, two},
                       fmt::format("{0}wrap_mode0 = {1}\nwrap_mode2 = {1}\n", linear, wrap));
}

TEST_CASE("parity: mipmaps, and the filter between their levels") {
    const std::string small =
        shader_of(fmt::format("textureLod(Source, {}, 1.4)", turned), {"Source"});
    for (const char* filter : {"", "filter_linear1 = true\n", "filter_linear1 = false\n"})
        for (const char* behind : {"", "mipmap_input2 = true\n"})
            check_same({reads_source, small, small},
                       fmt::format("mipmap_input1 = true\n{}{}", filter, behind));
}

TEST_CASE("parity: formats of targets") {
    const std::string dark = shader_of("texture(Source, at) * 0.37", {"Source"});
    const std::string twice = shader_of("texture(Source, at) * 2.0", {"Source"});
    check_same({dark, twice}, "scale_type0 = source\nsrgb_framebuffer0 = true\n");
    check_same({dark, twice}, "scale_type0 = source\nfloat_framebuffer0 = true\n");
    check_same({dark, twice}, "float_framebuffer0 = true\n");  // no effect without a scale
    for (const char* format : {"R8_UNORM", "R8G8_UNORM", "R8G8B8A8_SRGB", "R16_SFLOAT",
                               "A2B10G10R10_UNORM_PACK32", "R32G32B32A32_SFLOAT"})
        check_same({shader_of("texture(Source, at) * 0.37", {"Source"},
                              fmt::format("#pragma format {}\n", format)),
                    twice},
                   "");
    check_same({shader_of("uvec4(texture(Source, at).r * 4e9)", {"Source"},
                          "#pragma format R32_UINT\n#pragma name Whole\n", "uvec4"),
                shader_of("vec4(float(texture(Whole, at).r) / 4e9)", {"Whole"})},
               "");
    for (const char* format : {"R8G8B8A8_SINT", "R16_SINT", "R32G32B32A32_SINT"})
        check_same(
            {shader_of("ivec4(texture(Source, at) * 250.0 - 125.0)", {"Source"},
                       fmt::format("#pragma format {}\n#pragma name Signed\n", format), "ivec4"),
             shader_of("vec4(texture(Signed, at)) / 250.0 + 0.5", {"Signed"})},
            "");
}

TEST_CASE("parity: sizes are rounded, and passed as uniforms") {
    const std::string sizes = shader_of(
        "vec4(push.SourceSize.xy / 128.0, push.OutputSize.y / 128.0, 1.0) * 0.5 +"
        " u.OriginalSize.zwzw + vec4(u.FinalViewportSize.xy / 512.0, 0.0, 0.0) +"
        " texture(Source, at) * 0.2 * u.bright",
        {"Source"});
    check_same({sizes, sizes, sizes},
               "scale_type0 = source\nscale0 = 0.5\nscale_type_x1 = viewport\n"
               "scale_x1 = 0.31\nscale_type_y1 = absolute\nscale_y1 = 17\n"
               "bright = 0.75\n");
    check_same({sizes, sizes}, "scale_type0 = source\nscale0 = 0.001\n");
}

TEST_CASE("parity: frames are counted from 0, modulo each pass's own number") {
    const std::string count =
        shader_of("texture(Source, at) * 0.5 + float(push.FrameCount) / 16.0", {"Source"});
    check_same({count, count}, "frame_count_mod0 = 4\n");
}

TEST_CASE("parity: feedback and history") {
    const std::string mixes = shader_of(
        fmt::format("texture(Source, at) * 0.4 + texture(LaterFeedback, {}) * 0.5", turned),
        {"Source", "LaterFeedback"});
    const std::string later = shader_of("texture(Source, at)", {"Source"}, "#pragma name Later\n");
    check_same({mixes, later, copies}, "filter_linear1 = true\n");
    check_same({mixes, later, copies}, "filter_linear0 = true\nwrap_mode1 = repeat\n");
    check_same({shader_of(fmt::format("texture(OriginalHistory3, {0}) * 0.5 +"
                                      " texture(OriginalHistory1, {0}) * 0.5",
                                      turned),
                          {"OriginalHistory1", "OriginalHistory3"})},
               "filter_linear0 = true\n");
}

TEST_CASE("parity: textures, also a missing one") {
    const ParityFolder folder;
    folder.save_lut("lut.png");
    const std::string shader = shader_of(
        fmt::format("texture(lut, {0}) + texture(gone, at) * 0.5 + textureLod(small, {0}, 1.3)",
                    turned),
        {"lut", "gone", "small"});
    const std::string lines =
        "textures = \"lut;small;gone\"\nlut = lut.png\nlut_wrap_mode = repeat\nsmall = lut.png\n"
        "small_mipmap = true\ngone = none.png\n";
    check_same(folder.difference({shader}, lines));
    check_same(folder.difference({shader}, lines + "lut_linear = false\nsmall_linear = false\n"));
}

TEST_CASE("parity: an alias overrides a built-in name") {
    check_same({shader_of("texture(Source, at).bgra", {"Source"}), copies,
                shader_of("texture(Original, at)", {"Original"})},
               "alias0 = Original\n");
}

TEST_CASE("parity: gl_FragCoord counts up in the picture and down in earlier passes") {
    const std::string rows =
        shader_of("texture(Source, at) * 0.5 + gl_FragCoord.y / 128.0", {"Source"});
    check_same({rows, rows}, "");
    check_same({rows}, "scale_type0 = viewport\n");
}

TEST_CASE("parity: looks exported as presets") {
    constexpr Extent view{160, 120};
    const auto roots = find_roots({});
    REQUIRE(roots.has_value());
    const auto target = find_export_target("slang");
    REQUIRE(target.has_value());
    const TemporaryFolder folder;
    int number = 0;
    for (const auto& [look, preset] : {std::pair("crt", "film-transfer"),
                                       {"crt", "arcade-cabinet"},
                                       {"shadow-mask", "living-room"},
                                       {"shadow-mask", "dot-triads"},
                                       {"phosphor", "p31-terminal"},
                                       {"crt+shadow-mask", ""}}) {
        const std::string name = fmt::format("{} {}", look, preset);
        INFO(name);
        RenderRequest request;
        request.look = look;
        request.preset = preset;
        request.source = "pattern:harbour,size=120x90";
        request.size = view;
        const auto prepared = prepare(request, Library(*roots));
        REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
        const auto file = folder / fmt::format("{}.slangp", number++);
        const auto made = export_look(**target, {*prepared, view, file});
        REQUIRE_MESSAGE(made.has_value(), problems_of(made));
        auto pair = plain::Pair::open(file, {120, 90}, view);
        REQUIRE_MESSAGE(pair.has_value(), problems_of(pair));
        const auto difference = pair->compare(4);
        REQUIRE(difference.has_value());
        check_same(*difference);
    }
}

TEST_CASE("the public corpus of slang presets is drawn as plain calls draw it") {
    constexpr int sample = 12;
    constexpr int seed = 3;
    const char* folder = std::getenv("AFTERGLOW_SLANG_DIR");
    if (!folder) {
        MESSAGE("skipped: AFTERGLOW_SLANG_DIR does not name a copy of libretro's slang-shaders");
        return;
    }
    for (const char* part : {"/interpolation/", "/misc/", "/motionblur/", "/handheld/"})
        for (const auto& file :
             corpus_files(std::string(folder) + part, {".slangp", sample, seed})) {
            INFO(file.string());
            auto pair = plain::Pair::open(file, {160, 120}, {320, 240});
            REQUIRE_MESSAGE(pair.has_value(), problems_of(pair));
            const auto difference = pair->compare(5);
            REQUIRE(difference.has_value());
            check_same(*difference);
        }
}
