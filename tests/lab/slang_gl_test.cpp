// Output of libretro shader chains, rule by rule.
#include "io/pictures/picture_file.h"
#include "io/temporary_folder.h"
#include "lab/document/content_edits.h"
#include "lab/document/opened_preset.h"
#include "lab/offline/offline.h"
#include "lab/small_lab.h"
#include "problems_of.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

namespace {
constexpr const char* chain_head = R"(#version 450
layout(std140, set = 0, binding = 0) uniform UBO {
    mat4 MVP; vec4 SourceSize; vec4 OutputSize; vec4 FinalViewportSize; vec4 OriginalHistorySize1;
    uint FrameCount; uint FrameTimeDelta; int FrameDirection; uint Rotation; float OriginalFPS;
    uint TotalSubFrames; float level;
} u;
#pragma parameter level "Level" 0.25 0.0 1.0 0.01
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 at;
void main() { gl_Position = u.MVP * Position; at = TexCoord; }
#pragma stage fragment
layout(location = 0) in vec2 at;
)";

std::string chain_shader(const std::string& color, const std::vector<std::string>& samplers = {},
                         const std::string& pragmas = "", const std::string& type = "vec4") {
    std::string text = chain_head + pragmas + "layout(location = 0) out " + type + " FragColor;\n";
    int binding = 1;
    for (const std::string& sampler : samplers)
        text += fmt::format("layout(set = 0, binding = {}) uniform {}sampler2D {};\n", ++binding,
                            sampler.starts_with("Whole")    ? "u"
                            : sampler.starts_with("Signed") ? "i"
                                                            : "",
                            sampler);
    return text + "void main() { FragColor = " + color + "; }\n";
}

const std::string copies_source = chain_shader("texture(Source, at)", {"Source"});

/// Draws a preset with the shaders 0.slang, 1.slang, ...
class DrawnChain {
public:
    DrawnChain(const std::vector<std::string>& shaders, const std::string& lines) {
        std::string text = fmt::format("shaders = {}\n", shaders.size());
        for (std::size_t i = 0; i < shaders.size(); ++i) {
            m_folder.write(fmt::format("{}.slang", i), shaders[i]);
            text += fmt::format("shader{0} = {0}.slang\n", i);
        }
        m_folder.write("a.slangp", text + lines);
    }

    Offline open(Extent size, const Picture& source, const std::string& level = "",
                 const std::string& settings = "") const {
        const auto roots = find_roots({});
        REQUIRE(roots.has_value());
        RenderRequest request;
        request.look = (m_folder / "a.slangp").string();
        request.size = size;
        request.source = (m_folder / "source.png").string();
        REQUIRE(save_picture(source, request.source).has_value());
        request.source += settings;
        if (!level.empty())
            request.values.emplace_back("level", level);
        if (!filter.empty())
            request.values.emplace_back("unspecified_filter", filter);
        auto prepared = prepare(request, Library(*roots));
        REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
        CHECK(to_string(prepared->warnings) == "");
        auto offline = Offline::create(std::move(*prepared), size, 60.0);
        REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
        return std::move(*offline);
    }

    std::string filter = {};  // for passes without a filter; "": the default

private:
    TemporaryFolder m_folder;
};

// Red contains the display values 0, 1/8, ... row by row from the top; blue is 1.
Picture counted(Extent extent) {
    Picture picture{extent, 4, Encoding::display, {}};
    for (int i = 0; i < extent.width * extent.height; ++i)
        for (const float number : {static_cast<float>(i) / 8.0f, 0.0f, 1.0f, 1.0f})
            picture.pixels.push_back(number);
    return picture;
}

Picture flat(float level) {
    return {{1, 1}, 4, Encoding::display, {level, level, level, 1.0f}};
}

// In 8-bit levels.
int red(const Picture& picture, int x, int y) {
    return static_cast<int>(std::lround(picture.pixels[picture.index(x, y)] * 255.0f));
}

int first_red(const Picture& picture) {
    return red(picture, 0, 0);
}
}  // namespace

TEST_CASE("the picture is oriented like its source, for any number of passes") {
    const Picture source = counted({2, 3});
    for (const std::size_t passes : {1U, 2U, 3U})
        for (const char* last : {"", "scale_type0 = source\n"}) {
            const DrawnChain chain(std::vector<std::string>(passes, copies_source),
                                   passes == 1 ? last : "");
            Offline offline = chain.open({2, 3}, source);
            const Picture picture = offline.picture_after(1);
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 2; ++x)
                    CHECK(red(picture, x, y) == std::lround((y * 2 + x) / 8.0 * 255.0));
            CHECK(first_red(offline.picture(0)) == 0);
        }
}

TEST_CASE("the user chooses unspecified filters, and the preset specifies the others") {
    const Picture source = {{2, 1}, 4, Encoding::display, {0, 0, 0, 1, 1, 1, 1, 1}};
    // Texel centres are at 1/4 and 3/4 of the width, those of the picture at 1/8, 3/8, 5/8 and 7/8.
    const std::array nearest{0, 0, 255, 255};
    const std::array linear{0, 64, 191, 255};
    struct Case {
        const char* said;
        const char* chosen;
        const std::array<int, 4>& expected;
    };
    for (const Case& one : {Case{"", "", nearest}, Case{"", "nearest", nearest},
                            Case{"", "linear", linear}, Case{"filter_linear0 = true\n", "", linear},
                            Case{"filter_linear0 = false\n", "", nearest}}) {
        CAPTURE(one.said);
        CAPTURE(one.chosen);
        DrawnChain chain({copies_source}, std::string("wrap_mode0 = clamp_to_edge\n") + one.said);
        chain.filter = one.chosen;
        Offline offline = chain.open({4, 1}, source);
        const Picture picture = offline.picture_after(1);
        for (int x = 0; x < 4; ++x)
            CHECK(std::abs(red(picture, x, 0) - one.expected[static_cast<std::size_t>(x)]) <= 1);
        const bool is_open = *one.said == '\0';
        CHECK((find_parameter(offline.document().look(), "unspecified_filter") != nullptr) ==
              is_open);
    }
}

TEST_CASE("a last pass with its own size is scaled with the chosen filter") {
    DrawnChain chain({copies_source},
                     "wrap_mode0 = clamp_to_edge\nfilter_linear0 = false\nscale_type0 = source\n");
    chain.filter = "linear";
    Offline offline = chain.open({4, 1}, {{2, 1}, 4, Encoding::display, {0, 0, 0, 1, 1, 1, 1, 1}});
    const Picture picture = offline.picture_after(1);
    CHECK(std::abs(red(picture, 1, 0) - 64) <= 1);
    CHECK(std::abs(red(picture, 2, 0) - 191) <= 1);
}

TEST_CASE("texture coordinates start at the top left in every pass") {
    const DrawnChain chain({chain_shader("vec4(at.y)"),
                            chain_shader("texture(Source, at) * 0.5 + at.y * 0.5", {"Source"})},
                           "");
    Offline offline = chain.open({1, 4}, flat(0.0f));
    const Picture picture = offline.picture_after(1);
    // The first pass has the size of the source, one pixel: 0.5 everywhere.
    for (int y = 0; y < 4; ++y)
        CHECK(std::abs(red(picture, 0, y) - (0.25 + (y + 0.5) / 8.0) * 255.0) <= 1.0);
}

TEST_CASE("FrameCount counts from 0 and restarts at its modulo") {
    const DrawnChain chain({chain_shader("vec4(float(u.FrameCount) / 8.0)")},
                           "frame_count_mod0 = 3\n");
    Offline offline = chain.open({1, 1}, flat(0.0f));
    for (const int expected : {0, 32, 64, 0, 32})
        CHECK(first_red(offline.picture_after(1)) == expected);
}

TEST_CASE("uniforms that are constant on a desktop have the values of a desktop") {
    const DrawnChain chain(
        {chain_shader("vec4(u.FrameDirection == 1 && u.Rotation == 0u && u.OriginalFPS == 60.0 && "
                      "u.TotalSubFrames == 1u && u.FrameTimeDelta == 16667u ? 1.0 : 0.0)")},
        "");
    CHECK(first_red(chain.open({1, 1}, flat(0.0f)).picture_after(1)) == 255);
}

TEST_CASE("a parameter changes in both stages at once") {
    std::string shader = chain_shader("vec4(at.x * u.level)");
    const DrawnChain chain({replaced(shader, "at = TexCoord", "at = vec2(u.level)")}, "");
    CHECK(first_red(chain.open({1, 1}, flat(0.0f)).picture_after(1)) ==
          std::lround(0.0625 * 255.0));
    CHECK(first_red(chain.open({1, 1}, flat(0.0f), "1").picture_after(1)) == 255);
}

TEST_CASE("a last pass with a scale is drawn at its own size and scaled to the picture") {
    const std::string sizes =
        chain_shader("vec4(u.OutputSize.x / 16.0, u.FinalViewportSize.x / 16.0, 0.0, 1.0)");
    Offline own =
        DrawnChain({sizes}, "scale_type0 = source\nscale0 = 2.0\n").open({8, 4}, flat(0.0f));
    const Picture stretched = own.picture_after(1);
    CHECK(stretched.extent == Extent{8, 4});
    CHECK(first_red(stretched) == std::lround(2.0 / 16.0 * 255.0));
    CHECK(std::lround(stretched.pixels[1] * 255.0f) == std::lround(8.0 / 16.0 * 255.0));
    Offline whole = DrawnChain({sizes}, "").open({8, 4}, flat(0.0f));
    CHECK(first_red(whole.picture_after(1)) == std::lround(8.0 / 16.0 * 255.0));
}

TEST_CASE("feedback is the previous frame of a pass, initially transparent black") {
    const DrawnChain chain(
        {chain_shader("texture(PassFeedback0, at) + 0.125", {"PassFeedback0"}), copies_source}, "");
    Offline offline = chain.open({1, 1}, flat(0.0f));
    for (const int expected : {32, 64, 96})
        CHECK(std::abs(first_red(offline.picture_after(1)) - expected) <= 1);
}

TEST_CASE("feedback by alias may refer to a later pass") {
    const DrawnChain chain(
        {chain_shader("texture(LaterFeedback, at) + 0.25", {"LaterFeedback"}),
         chain_shader("texture(Source, at) * 0.5", {"Source"}, "#pragma name Later\n"),
         copies_source},
        "");
    Offline offline = chain.open({1, 1}, flat(0.0f));
    // 0.25 / 2; (0.125 + 0.25) / 2; (0.1875 + 0.25) / 2
    for (const double expected : {0.125, 0.1875, 0.21875})
        CHECK(std::abs(first_red(offline.picture_after(1)) - expected * 255.0) <= 1.0);
}

TEST_CASE("history is the source of previous frames, initially transparent black") {
    const DrawnChain chain({chain_shader("texture(OriginalHistory2, at) * u.OriginalHistorySize1.x",
                                         {"OriginalHistory2"})},
                           "");
    Offline offline = chain.open({1, 1}, flat(0.2f));
    CHECK(first_red(offline.picture_after(1)) == 0);
    REQUIRE(offline.override_source(flat(0.4f)));
    CHECK(first_red(offline.picture_after(1)) == 0);
    REQUIRE(offline.override_source(flat(0.6f)));
    CHECK(first_red(offline.picture_after(1)) == 51);
    CHECK(first_red(offline.picture_after(1)) == 102);
}

TEST_CASE("outside of a texture is transparent black unless its wrap mode differs") {
    const std::string shader = chain_shader("texture(Source, at + vec2(1.0, 0.0))", {"Source"});
    CHECK(first_red(DrawnChain({shader}, "").open({1, 1}, flat(1.0f)).picture_after(1)) == 0);
    CHECK(first_red(DrawnChain({shader}, "wrap_mode0 = clamp_to_edge\n")
                        .open({1, 1}, flat(1.0f))
                        .picture_after(1)) == 255);
}

TEST_CASE("an sRGB target is encoded when drawn and decoded when read") {
    const DrawnChain chain(
        {chain_shader("vec4(0.5)"), chain_shader("texture(Source, at)", {"Source"})},
        "scale_type0 = source\nsrgb_framebuffer0 = true\n");
    Offline offline = chain.open({1, 1}, flat(0.0f));
    // 0.5 is encoded as 187.5 of 255 (IEC 61966-2-1).
    CHECK(std::abs(first_red(offline.picture_after(1)) - 127.5) <= 1.0);
    CHECK(std::abs(first_red(offline.picture(0)) - 187.5) <= 1.0);
}

TEST_CASE("a chain reads its source in 8 bits") {
    // 0.25 is 63.75 of 255.
    const DrawnChain chain(
        {chain_shader("vec4((texture(Source, at).r * 255.0 - 63.0) * 0.5)", {"Source"})}, "");
    Offline offline = chain.open({1, 1}, flat(0.0f));
    REQUIRE(offline.override_source(flat(0.25f)));
    CHECK(std::abs(first_red(offline.picture_after(1)) - 127.5) <= 1.0);
}

TEST_CASE("numbers can be packed as half floats") {
    const DrawnChain chain({chain_shader("unpackHalf2x16(packHalf2x16(vec2(u.level, 0.5))).xyxy")},
                           "");
    CHECK(std::abs(first_red(chain.open({1, 1}, flat(0.0f)).picture_after(1)) - 63.75) <= 1.0);
}

TEST_CASE("integers pass through an integer target unchanged") {
    const DrawnChain chain(
        {chain_shader("uvec4(4000000000u)", {}, "#pragma format R32_UINT\n#pragma name Whole\n",
                      "uvec4"),
         chain_shader("vec4(texture(Whole, at).r == 4000000000u ? 1.0 : 0.0)", {"Whole"})},
        "");
    CHECK(first_red(chain.open({1, 1}, flat(0.0f)).picture_after(1)) == 255);
}

TEST_CASE("negative integers pass unchanged through every signed target and its feedback") {
    struct Signed {
        std::string format;
        std::string minimum;
        float read = 0.0f;
    };
    const std::string of_32 = "(-2147483647 - 1)";
    for (const Signed& one :
         {Signed{"R8_SINT", "-128", -128.0f}, Signed{"R8G8_SINT", "-128", -128.0f},
          Signed{"R8G8B8A8_SINT", "-128", -128.0f}, Signed{"R16_SINT", "-32768", -32768.0f},
          Signed{"R16G16_SINT", "-32768", -32768.0f},
          Signed{"R16G16B16A16_SINT", "-32768", -32768.0f},
          Signed{"R32_SINT", of_32, -2147483648.0f}, Signed{"R32G32_SINT", of_32, -2147483648.0f},
          Signed{"R32G32B32A32_SINT", of_32, -2147483648.0f}}) {
        CAPTURE(one.format);
        const DrawnChain chain(
            {chain_shader(fmt::format("ivec4({})", one.minimum), {},
                          fmt::format("#pragma format {}\n#pragma name Signed\n", one.format),
                          "ivec4"),
             chain_shader(fmt::format("vec4(texture(Signed, at).r == {0} ? 0.2 : 0.0) +"
                                      " vec4(texture(SignedFeedback, at).r == {0} ? 0.4 : 0.0)",
                                      one.minimum),
                          {"Signed", "SignedFeedback"})},
            "");
        Offline offline = chain.open({1, 1}, flat(0.0f));
        CHECK(first_red(offline.picture_after(1)) == 51);
        CHECK(first_red(offline.picture_after(1)) == 153);
        CHECK(offline.picture(0).pixels[0] == one.read);
    }
}

TEST_CASE("the smallest level of a mipmapped input is the mean of the input") {
    const DrawnChain chain(
        {copies_source, chain_shader("textureLod(Source, at, 1.0)", {"Source"})},
        "mipmap_input1 = true\nfilter_linear1 = true\nwrap_mode1 = clamp_to_edge\n");
    const Picture source{{2, 2}, 1, Encoding::display, {0.0f, 1.0f, 1.0f, 0.0f}};
    CHECK(std::abs(first_red(chain.open({2, 2}, source).picture_after(1)) - 127.5) <= 1.0);
}

namespace {
/// A lab with an open chain of one pass.
class SlangLab : public SmallLab {
public:
    SlangLab() {
        m_files.write("0.slang", chain_shader("vec4(u.level)"));
        m_files.write("a.slangp", "shaders = 1\nshader0 = 0.slang\n");
        open_preset("a.slangp");
    }
    void open_preset(const std::string& name) {
        lab().looks().open(file(name).string());
        REQUIRE(update_until([&] { return document().look().manifest == file(name); }));
    }
    std::filesystem::path file(const std::string& name) const { return m_files / name; }
    double level() {
        return document().value(*find_parameter(document().look(), "level")).number();
    }

private:
    TemporaryFolder m_files;
};
}  // namespace

TEST_CASE("changed parameters are saved as a .slangp that references the open one") {
    SlangLab slang;
    REQUIRE(slang.lab().presets().sharing().can_save_slang());
    slang.lab().edit([](Document& document) { document.set_value("level", Value(0.75)); });
    slang.lab().presets().sharing().save_slang(slang.file("a.slangp"));
    CHECK(slang.lab().messages().notice()->text ==
          "A .slangp file can't reference itself. Choose another name.");
    slang.lab().presets().sharing().save_slang(slang.file("mine"));
    slang.open_preset("mine.slangp");
    CHECK(slang.level() == 0.75);
    slang.lab().presets().sharing().save_slang(
        slang.file("a.slangp"));  // would be a circular reference
    CHECK(slang.lab().messages().notice()->text ==
          "The open look uses this file. Choose another name.");
    CHECK_FALSE(is_modified(slang.document()));
    slang.lab().looks().open("small");
    REQUIRE(slang.update_until([&] { return slang.document().look().id == "small"; }));
    CHECK_FALSE(slang.lab().presets().sharing().can_save_slang());
}

TEST_CASE("a single open shader is saved as a .slangp that draws it") {
    SlangLab slang;
    slang.open_preset("0.slang");
    slang.lab().edit([](Document& document) { document.set_value("level", Value(0.75)); });
    slang.lab().presets().sharing().save_slang(slang.file("alone"));
    slang.open_preset("alone.slangp");
    CHECK(slang.level() == 0.75);
    CHECK(slang.document().look().passes.size() == 1);
}

TEST_CASE("a chain keeps its source's shape in the view until another shape is chosen") {
    SlangLab slang;
    slang.lab().work().size.set_view({100, 60});
    slang.lab().work().size.choose({});
    const FittedSource& source = slang.lab().work().media.source();
    REQUIRE(slang.update_until([&] { return source.get() != nullptr; }));
    CHECK(slang.lab().work().size.extent() == Extent{80, 60});  // of 320 x 240
    slang.lab().edit(
        [](Document& document) { set_source(document, "pattern:harbour,size=16x16,aspect=1.25"); });
    REQUIRE(slang.update_until([&] { return source.get()->extent() == Extent{16, 16}; }));
    CHECK(slang.lab().work().size.extent() == Extent{75, 60});
    PictureSize size;
    size.shape = ViewShape::whole_pixels;
    slang.lab().work().size.choose(size);
    CHECK(slang.lab().work().size.extent() == Extent{60, 48});
    size.shape = ViewShape::view;
    slang.lab().work().size.choose(size);
    CHECK(slang.lab().work().size.extent() == Extent{100, 60});
}

TEST_CASE("OriginalAspect is the aspect ratio of the source including its pixel aspect") {
    std::string shader = chain_shader("vec4(u.aspect / 4.0)");
    shader = replaced(shader, "float level;", "float level; float OriginalAspect;");
    shader = replaced(shader, "u.aspect", "u.OriginalAspect");
    const DrawnChain chain({shader}, "");
    CHECK(first_red(chain.open({4, 4}, counted({4, 2})).picture_after(1)) == 128);  // 2 of 4
    Offline wide = chain.open({4, 4}, counted({4, 2}), "", ",aspect=1.5");
    CHECK(first_red(wide.picture_after(1)) == 191);  // 3 of 4
}
