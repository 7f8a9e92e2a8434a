#include "base/pass_progress.h"
#include "formats/slang/slang_folder.h"
#include "formats/slang/slang_format.h"
#include "problems_of.h"

#include <fmt/format.h>

namespace {
constexpr const char* head = R"(#version 450
layout(push_constant) uniform Push { vec4 SourceSize; uint FrameCount; float glow; float dim; } params;
layout(std140, set = 0, binding = 0) uniform UBO { mat4 MVP; } global;
#pragma parameter glow "Glow" 0.5 0.0 1.0 0.1
#pragma stage vertex
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 vTexCoord;
void main() { gl_Position = global.MVP * Position; vTexCoord = TexCoord; }
#pragma stage fragment
layout(location = 0) in vec2 vTexCoord;
layout(location = 0) out vec4 FragColor;
)";

// A shader that adds up its samplers.
std::string reading(const std::vector<std::string>& samplers, const std::string& pragmas = "",
                    const std::string& more = "vec4(0.0)") {
    std::string text = head + pragmas;
    std::string sum = more;
    int binding = 1;
    for (const std::string& sampler : samplers) {
        text += fmt::format("layout(set = 0, binding = {}) uniform sampler2D {};\n", ++binding,
                            sampler);
        sum += fmt::format(" + texture({}, vTexCoord)", sampler);
    }
    return text + "void main() { FragColor = " + sum + "; }\n";
}

/// A temporary folder with shaders 0.slang, 1.slang and so on, and the look of a preset with them.
class ChainFolder : public SlangFolder {
public:
    explicit ChainFolder(const std::vector<std::string>& shaders) : m_count(shaders.size()) {
        for (std::size_t i = 0; i < shaders.size(); ++i)
            write(fmt::format("{}.slang", i), shaders[i]);
    }

    LoadedLook load(const std::string& lines = "") {
        std::string text = fmt::format("shaders = {}\n", m_count);
        for (std::size_t i = 0; i < m_count; ++i)
            text += fmt::format("shader{0} = {0}.slang\n", i);
        return load_slang_look(write("a.slangp", text + lines), {});
    }
    Look look(const std::string& lines = "") {
        LoadedLook loaded = load(lines);
        REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
        CHECK(told(loaded.warnings) == "");
        return *loaded.look;
    }

private:
    std::size_t m_count;
};

const Input& input(const Look& look, std::size_t pass, const std::string& uniform) {
    for (const Input& found : look.passes[pass].inputs)
        if (found.uniform == uniform)
            return found;
    FAIL("pass " << pass << " has no input " << uniform);
    return look.passes[pass].inputs.front();
}

const std::string source_only = reading({"Source"});
}  // namespace

TEST_CASE("a last pass without a scale has the size of the view") {
    ChainFolder folder({source_only, source_only});
    const Look look = folder.look("scale_type0 = source\nscale0 = 2.0\n");
    REQUIRE(look.passes.size() == 2);
    CHECK(look.passes[0].size[0] == Side{Side::By::before, 2.0, {}});
    CHECK(look.passes[0].rows == RowOrder::top_first);
    CHECK(look.passes[1].size[1] == Side{Side::By::viewport, 1.0, {}});
    CHECK(look.passes[1].rows == RowOrder::bottom_first);
    CHECK(look.passes[0].name == "0");
    CHECK(input(look, 0, "Source").from == Input::From::source);
    CHECK(input(look, 1, "Source").name == "0");
    CHECK(look.source_rows == RowOrder::top_first);
    CHECK(look.source_encoding == Encoding::display);
    CHECK(look.source_format == Format::rgba8);
}

TEST_CASE("a last pass with a scale is stretched over the picture by an extra pass") {
    ChainFolder folder({source_only});
    const Look look = folder.look("scale_type0 = absolute\nscale_x0 = 64\nscale_y0 = 32\n");
    REQUIRE(look.passes.size() == 2);
    CHECK(look.passes[0].size[0] == Side{Side::By::pixels, 64.0, {}});
    CHECK(look.passes[0].size[1] == Side{Side::By::pixels, 32.0, {}});
    CHECK(look.passes[0].rows == RowOrder::top_first);
    CHECK(look.passes[1].rows == RowOrder::bottom_first);
    CHECK(look.passes[1].draw == Draw::quad);  // as all others
    CHECK(input(look, 1, "image").sampler == Sampler{Filter::nearest, Wrap::edge, false});
}

TEST_CASE("feedback of a last pass without a scale is kept") {
    ChainFolder folder({reading({"Source", "PassFeedback0"})});
    const Look look = folder.look();
    REQUIRE(look.passes.size() == 2);
    CHECK(input(look, 0, "PassFeedback0").frames_ago == 1);
    CHECK(input(look, 0, "PassFeedback0").name == "0");
}

TEST_CASE("filter and wrap belong to the texture that is read, not to its reader") {
    ChainFolder folder(
        {source_only, source_only,
         reading({"Source", "Original", "OriginalHistory2", "PassOutput0", "PassFeedback0"})});
    const Look look = folder.look(
        "filter_linear0 = true\nwrap_mode0 = repeat\n"
        "filter_linear1 = false\nwrap_mode1 = mirrored_repeat\n"
        "filter_linear2 = true\nwrap_mode2 = clamp_to_edge\n");
    const Sampler first{Filter::linear, Wrap::repeat, false};
    const Sampler second{Filter::nearest, Wrap::mirror, false};
    const Sampler third{Filter::linear, Wrap::edge, false};
    CHECK(input(look, 2, "Source").sampler == third);    // the reading pass
    CHECK(input(look, 2, "Original").sampler == first);  // the first pass
    CHECK(input(look, 2, "OriginalHistory2").sampler == first);
    CHECK(input(look, 2, "OriginalHistory2").frames_ago == 2);
    CHECK(input(look, 2, "PassOutput0").sampler == second);   // the following pass
    CHECK(input(look, 2, "PassFeedback0").sampler == first);  // the pass itself
}

TEST_CASE("the default sampler is nearest with a transparent black border") {
    ChainFolder folder({source_only});
    CHECK(input(folder.look(), 0, "Source").sampler ==
          Sampler{Filter::nearest, Wrap::border, false});
}

TEST_CASE("a pass has mipmaps if the following pass requests them") {
    ChainFolder folder({source_only, source_only, source_only});
    const std::string linear =
        "filter_linear0 = true\nfilter_linear1 = true\nfilter_linear2 = true\n";
    const Look one = folder.look(linear + "mipmap_input1 = true\n");
    CHECK(input(one, 1, "Source").sampler.mipmap);
    // Linear between levels only if the pass that owns the state reads mipmaps itself.
    CHECK(input(one, 1, "Source").sampler.between_levels == Filter::nearest);
    CHECK_FALSE(input(one, 2, "Source").sampler.mipmap);
    const Look two = folder.look(linear + "mipmap_input1 = true\nmipmap_input2 = true\n");
    CHECK(input(two, 1, "Source").sampler.between_levels == Filter::linear);
    CHECK_FALSE(input(folder.look("mipmap_input0 = true\n"), 0, "Source").sampler.mipmap);
    // The default filter is nearest, but linear between levels.
    const Look unsaid = folder.look("mipmap_input1 = true\nmipmap_input2 = true\n");
    CHECK(input(unsaid, 1, "Source").sampler ==
          Sampler{Filter::nearest, Wrap::border, true, Filter::linear});
}

TEST_CASE("the format is the shader's, unless a scaled pass requests sRGB or float") {
    ChainFolder folder({reading({"Source"}, "#pragma format R16G16B16A16_SFLOAT\n"), source_only});
    CHECK(folder.look().passes[0].format == Format::rgba16f);
    CHECK(folder.look("srgb_framebuffer0 = true\n").passes[0].format == Format::rgba16f);
    const std::string scaled = "scale_type0 = source\n";
    CHECK(folder.look(scaled + "srgb_framebuffer0 = true\n").passes[0].format ==
          Format::srgb8_alpha8);
    CHECK(folder.look(scaled).passes[1].format == Format::rgba8);
    CHECK(folder.look("scale_type1 = source\nfloat_framebuffer1 = true\n").passes[1].format ==
          Format::rgba16f);
    ChainFolder last({reading({"Source"}, "#pragma format R32_SFLOAT\n")});
    CHECK(last.look().passes[0].format == Format::rgba8);  // as the screen
}

TEST_CASE("passes are named by alias, the preset's before the shader's") {
    ChainFolder folder({reading({"Source"}, "#pragma name First\n"),
                        reading({"Source"}, "#pragma name Hidden\n"),
                        reading({"First", "Second", "FirstFeedback"})});
    const Look look = folder.look("alias1 = Second\n");
    CHECK(pass_names(look) == std::vector<std::string>{"First", "Second", "2"});
    CHECK(input(look, 2, "First").name == "First");
    CHECK(input(look, 2, "Second").name == "Second");
    CHECK(input(look, 2, "FirstFeedback").frames_ago == 1);
}

TEST_CASE("a parameter sets its member in every pass, and starts with the preset's value") {
    const std::string glowing = reading({"Source"}, "", "vec4(params.glow)");
    ChainFolder folder({glowing, source_only, glowing});
    const Look look = folder.look("glow = \"2.5\"\nunknown = 3\n");
    REQUIRE(parameter_names(look) == std::vector<std::string>{"glow", "unspecified_filter"});
    CHECK(look.parameters[0].initial.number() == 2.5);
    CHECK(look.parameters[0].range.high == 2.5);  // widened
    CHECK(look.parameters[0].bindings ==
          std::vector<Binding>{{0, "fragment_constants.glow"}, {2, "fragment_constants.glow"}});
}

TEST_CASE("built-in members are set, sizes included") {
    ChainFolder folder({reading({"Source"}, "", "params.SourceSize + float(params.FrameCount)")});
    const Pass pass = folder.look("frame_count_mod0 = 30\n").passes[0];
    CHECK(pass.frame_modulo == 30);
    const auto told = [&](const std::string& uniform) {
        const auto found = std::ranges::find(pass.built_ins, uniform, &BuiltInUniform::name);
        REQUIRE_MESSAGE(found != pass.built_ins.end(), uniform);
        return *found;
    };
    CHECK(told("vertex_uniforms.MVP").kind == BuiltIn::quad_to_clip);
    CHECK(told("fragment_constants.FrameCount").kind == BuiltIn::source_frame_index);
    CHECK(told("fragment_constants.SourceSize").kind == BuiltIn::input_extent);
    CHECK(told("fragment_constants.SourceSize").of->from == Input::From::source);
}

TEST_CASE("an unknown member is 0 and an unknown sampler is black, with warnings") {
    ChainFolder folder({reading({"Source", "play"}, "", "vec4(params.dim)")});
    const LoadedLook loaded = folder.load();
    REQUIRE(loaded.look.has_value());
    CHECK(folder.told(loaded.warnings) ==
          "a.slangp:2: warning: pass '0' reads the unknown texture 'play'; it is black\n"
          "a.slangp:2: warning: pass '0' reads the unknown uniform 'dim'; it is 0");
}

TEST_CASE("a pass that reads a later pass is an error with its name") {
    ChainFolder folder({reading({"Source", "PassOutput1"}), source_only});
    CHECK(folder.refusal(folder.load().look) ==
          "a.slangp:2: error: pass '0' reads 'PassOutput1', which is not an earlier pass");
    ChainFolder itself({reading({"PassOutput0"})});
    CHECK_FALSE(itself.load().look.has_value());
}

TEST_CASE("two passes with one name are an error") {
    ChainFolder folder({source_only, source_only});
    CHECK(folder.refusal(folder.load("alias0 = A\nalias1 = A\n").look) ==
          "a.slangp:3: error: passes 0 and 1 are both named 'A'");
}

TEST_CASE("a missing texture is black with a warning, and an existing one is an image") {
    ChainFolder folder({reading({"Source", "mask", "grid"})});
    folder.write("m.png", "any");
    const LoadedLook loaded = folder.load(
        "textures = \"mask;grid\"\nmask = m.png\nmask_wrap_mode = repeat\nmask_mipmap = true\n"
        "grid = none.png\n");
    REQUIRE(loaded.look.has_value());
    CHECK(folder.told(loaded.warnings)
              .find("a.slangp:2: warning: pass '0' reads 'grid', but its picture '") == 0);
    CHECK(loaded.warnings.size() == 1);
    CHECK(loaded.warnings[0].message.ends_with("none.png' is missing; it is black"));
    REQUIRE(loaded.look->images.size() == 1);
    const Image& image = loaded.look->images[0];
    CHECK(image.sampler == Sampler{Filter::linear, Wrap::repeat, true});
    CHECK(image.is_linear);  // as stored
    CHECK(image.rows == RowOrder::top_first);
    CHECK(image.format == Format::rgba8);
    CHECK_FALSE(image.is_needed);
    CHECK(std::ranges::find(loaded.files, folder / "none.png") != loaded.files.end());
}

TEST_CASE("shader errors are reported at their own lines, once for all passes") {
    ChainFolder folder({head + std::string("void main() { FragColor = nothing; }\n"), source_only});
    const LoadedLook loaded = load_slang_look(
        folder.write("b.slangp", "shaders = 2\nshader0 = 0.slang\nshader1 = 0.slang\n"), {});
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(folder.told(loaded.look.error()).starts_with("0.slang:13: error: "));
    CHECK(loaded.look.error().size() == 1);
    CHECK(std::ranges::find(loaded.files, folder / "0.slang") != loaded.files.end());
}

TEST_CASE("a single shader is a chain with one pass") {
    ChainFolder folder({source_only});
    const LoadedLook loaded = load_slang_look(folder / "0.slang", {});
    REQUIRE(loaded.look.has_value());
    CHECK(loaded.look->id == "0.slang");
    CHECK(loaded.look->passes.size() == 1);
}

TEST_CASE("loading a chain reports progress per pass and can be cancelled") {
    ChainFolder folder({source_only, source_only, source_only});
    REQUIRE(folder.load().look.has_value());  // writes the preset
    std::vector<std::string> told;
    PassProgress* shared = nullptr;
    PassProgress progress([&](const PassProgress::State& state) {
        told.push_back(fmt::format("{} {}/{}", state.pass, state.done, state.total));
        if (told.size() == 5)
            shared->cancel();
    });
    shared = &progress;
    CHECK(load_slang_look(folder / "a.slangp", {nullptr, &progress}).look.has_value());
    CHECK(told == std::vector<std::string>{"0 0/3", "1 1/3", "2 2/3"});
    const LoadedLook cut = load_slang_look(folder / "a.slangp", {nullptr, &progress});
    REQUIRE_FALSE(cut.look.has_value());
    CHECK(folder.told(cut.look.error()) == "a.slangp: error: loading was cancelled");
    CHECK(told.size() == 5);
}

TEST_CASE("constants with a range are parameters of all passes that have them") {
    const std::string constant = "#define TAPS 3  // @range 1 9 @label \"Taps\"\n";
    const std::string sum = "vec4(float(TAPS) * 0.125)";
    ChainFolder folder({reading({"Source"}, constant, sum), reading({"Source"}),
                        reading({"Source"}, constant, sum)});
    const Look look = folder.look();
    const Parameter* const taps = find_parameter(look, "TAPS");
    REQUIRE(taps);
    CHECK(taps->label == "Taps");
    CHECK(taps->bindings == std::vector<Binding>{{0, "TAPS"}, {2, "TAPS"}});
    CHECK(look.passes[0].fragment.text->find("0.375") != std::string::npos);

    const Values values{{"TAPS", 5.0}};
    const LoadedLook turned = load_slang_look(folder / "a.slangp", {nullptr, nullptr, &values});
    REQUIRE(turned.look.has_value());
    CHECK(turned.look->passes[0].fragment.text->find("0.625") != std::string::npos);
    CHECK(turned.look->passes[1] == look.passes[1]);
}

TEST_CASE("the default filter is a parameter of the passes without a filter") {
    ChainFolder folder({reading({"Source"}), reading({"Source"}), reading({"Source"})});
    const std::string lines = "filter_linear0 = true\nfilter_linear2 = false\n";
    const Look look = folder.look(lines);
    const Parameter* const filter = find_parameter(look, "unspecified_filter");
    REQUIRE(filter);
    CHECK(filter->label == "Default filter");
    CHECK(parse_value(*filter, "linear").value() == Value(1.0));
    CHECK(filter->initial == Value(0.0));
    REQUIRE(filter->bindings.size() == 1);
    CHECK(filter->bindings[0].pass == 1);
    CHECK(look.passes[1].inputs[0].sampler.filter == Filter::nearest);

    const Values values{{"unspecified_filter", 1.0}};
    const LoadedLook linear = load_slang_look(folder / "a.slangp", {nullptr, nullptr, &values});
    REQUIRE(linear.look.has_value());
    CHECK(linear.look->passes[1].inputs[0].sampler.filter == Filter::linear);
    CHECK(linear.look->passes[0] == look.passes[0]);
    CHECK(linear.look->passes[2] == look.passes[2]);
    CHECK(linear.look->constants == values);
    CHECK_FALSE(
        find_parameter(folder.look(lines + "filter_linear1 = true\n"), "unspecified_filter"));
}

TEST_CASE("the number of sub-frames is a parameter if a pass reads them") {
    std::string text = reading({"Source"}, "", "vec4(params.TotalSubFrames)");
    const std::string_view last = "float dim;";
    text.replace(text.find(last), last.size(), "uint TotalSubFrames;");
    ChainFolder folder({reading({"Source"}), text});
    const Look look = folder.look();
    const Parameter* const count = find_parameter(look, "subframes");
    REQUIRE(count);
    CHECK(count->initial == Value(1.0));  // as in RetroArch
    CHECK(look.subframes == Count("subframes"));
    ChainFolder other({reading({"Source"})});
    CHECK_FALSE(find_parameter(other.look(), "subframes"));
    CHECK(other.look().subframes == Count(1));
}

TEST_CASE("a last pass that reads HDRMode writes scRGB with HDR") {
    std::string text = reading({"Source"}, "", "vec4(params.HDRMode)");
    const std::string_view last = "float dim;";
    text.replace(text.find(last), last.size(), "uint HDRMode;");
    ChainFolder folder({reading({"Source"}), text});
    CHECK(folder.look().is_scrgb_in_hdr);
    ChainFolder earlier({text, reading({"Source"})});
    CHECK_FALSE(earlier.look().is_scrgb_in_hdr);
}

TEST_CASE("an error in a chain names pass, file and line") {
    ChainFolder folder({reading({}), reading({}, "", "nope")});
    const LoadedLook broken = folder.load("alias1 = Middle\n");
    REQUIRE_FALSE(broken.look.has_value());
    const Diagnostic& wrong = broken.look.error().front();
    CHECK(wrong.file == folder / "1.slang");
    CHECK(wrong.line == 13);
    CHECK(wrong.message.starts_with("pass 'Middle': 'nope'"));

    const LoadedLook lacking = load_slang_look(
        folder.write("b.slangp", "shaders = 2\nshader0 = 0.slang\n\nshader1 = gone.slang\n"), {});
    REQUIRE_FALSE(lacking.look.has_value());
    const Diagnostic& missing = lacking.look.error().front();
    CHECK(missing.file == folder / "b.slangp");
    CHECK(missing.line == 4);
    CHECK(missing.message == "pass 'gone': can't read 'gone.slang' (" +
                                 (folder / "gone.slang").string() + "): file not found");
}
