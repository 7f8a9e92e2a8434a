#include "formats/look_format.h"
#include "formats/shadertoy/shadertoy_format.h"
#include "io/temporary_folder.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
constexpr const char* plain = "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, iTime, 1.0); }";

std::string json_pass(const std::string& type, const std::string& id, const std::string& code,
                      const std::string& inputs = "") {
    return R"({"type": ")" + type + R"(", "outputs": [{"id": ")" + id + R"("}], "code": ")" + code +
           R"(", "inputs": [)" + inputs + "]}";
}

std::string json_input(int channel, const std::string& type, const std::string& id = "",
                       const std::string& path = "") {
    return R"({"channel": )" + std::to_string(channel) + R"(, "type": ")" + type + R"(", "id": ")" +
           id + R"(", "filepath": ")" + path + R"("})";
}

const std::string reads_0 = "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }";

/// A temporary folder of Shadertoy files.
class ShadertoyFiles {
public:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return m_folder.write(name, text);
    }
    LoadedLook load_json(const std::string& passes) const {
        return load_shadertoy_look(write("a.json", "{\"renderpass\": [" + passes + "]}"), {}, {});
    }
    Look look_of_json(const std::string& passes) const { return good(load_json(passes)); }
    Look look_of_text(const std::string& text) const {
        return good(load_shadertoy_look(write("a.glsl", text), {}, {}));
    }
    Look good(LoadedLook loaded) const {
        REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
        CHECK(told(loaded.warnings) == "");
        return *loaded.look;
    }
    std::string told(const Diagnostics& diagnostics) const {
        std::string text = to_string(diagnostics);
        const std::string folder = m_folder.path().string() + "/";
        for (std::size_t at = text.find(folder); at != text.npos; at = text.find(folder))
            text.erase(at, folder.size());
        return text;
    }
    std::filesystem::path folder() const { return m_folder.path(); }

private:
    TemporaryFolder m_folder;
};

std::string names_of(const Look& look) {
    std::string names;
    for (const Pass& pass : look.passes)
        names += (names.empty() ? "" : ", ") + pass.name;
    return names;
}

const Input& input_in(const Look& look, const std::string& pass, const std::string& uniform) {
    const Pass& read = look.passes[static_cast<std::size_t>(find_pass(look, pass).value())];
    const auto found = std::ranges::find(read.inputs, uniform, &Input::uniform);
    REQUIRE(found != read.inputs.end());
    return *found;
}

bool tells(const Look& look, const std::string& uniform) {
    const auto& told = look.passes[0].built_ins;
    return std::ranges::find(told, uniform, &BuiltInUniform::name) != told.end();
}
}  // namespace

TEST_CASE("buffers are drawn from A to D, then the Image, in any order of listing") {
    const ShadertoyFiles files;
    const Look look = files.look_of_json(
        json_pass("image", "4dfGRr", plain) + "," + json_pass("buffer", "XdfGR8", plain) + "," +
        json_pass("buffer", "4dXGR8", plain) + "," + json_pass("buffer", "4sXGR8", plain));
    CHECK(names_of(look) == "Buffer A, Buffer C, Buffer D, Image");
    CHECK(look.passes[0].format == Format::rgba32f);
    CHECK(look.passes[3].format == Format::rgba8);
}

TEST_CASE("a buffer that is drawn later is read from the previous frame") {
    const ShadertoyFiles files;
    const std::string both =
        "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p) + texture(iChannel1, "
        "p); }";
    const Look look = files.look_of_json(
        json_pass("buffer", "4dXGR8", both,
                  json_input(0, "buffer", "4dXGR8") + "," + json_input(1, "buffer", "XsXGR8")) +
        "," + json_pass("buffer", "XsXGR8", reads_0, json_input(0, "buffer", "4dXGR8")) + "," +
        json_pass("image", "4dfGRr", reads_0, json_input(0, "buffer", "XsXGR8")));
    CHECK(input_in(look, "Buffer A", "iChannel0").reference() == "Buffer A@1");
    CHECK(input_in(look, "Buffer A", "iChannel1").reference() == "Buffer B@1");
    CHECK(input_in(look, "Buffer B", "iChannel0").reference() == "Buffer A");
    CHECK(input_in(look, "Image", "iChannel0").reference() == "Buffer B");
    CHECK(look.settle_frames == 60);
}

TEST_CASE("only the built-in uniforms that a shader reads are set") {
    const ShadertoyFiles files;
    const Look look = files.look_of_text(plain);
    CHECK(look.parameters.empty());
    CHECK(tells(look, "iTime"));
    CHECK_FALSE(tells(look, "iMouse"));
    CHECK_FALSE(reads_press(look));
    CHECK(reads_press(files.look_of_text("void mainImage(out vec4 c, in vec2 p) { c = iMouse; }")));
    CHECK(look.driven_by == Driver::nothing);
    CHECK(look.output == Encoding::display);
}

TEST_CASE("every built-in uniform is available, also if the author declares it") {
    const ShadertoyFiles files;
    const std::string all =
        "void mainImage(out vec4 c, in vec2 p) {\n"
        "    c = vec4(iResolution, iTime + iGlobalTime + iTimeDelta + iFrameRate) + iMouse;\n"
        "    c += vec4(iFrame) + iSampleRate + iChannelTime[3] + vec4(iChannelResolution[1], "
        "1.0);\n"
        "    c += texture(iCh0.sampler, p) + vec4(iCh0.size, iCh0.time) + float(iCh0.loaded);\n"
        "#ifdef HW_PERFORMANCE\n    c *= 2.0;\n#endif\n}\n";
    const Look look = files.look_of_text(all);
    CHECK(look.passes[0].set.at("iSampleRate").number() == 44100.0);
    CHECK(
        files.look_of_text("uniform float iTime;\nuniform vec3 iResolution;\n" + std::string(plain))
            .parameters.empty());
}

TEST_CASE("the author's own uniform is a parameter") {
    const ShadertoyFiles files;
    const Look look = files.look_of_text(
        "uniform float glow = 0.5; // @range 0 2\n"
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(glow); }\n");
    REQUIRE(look.parameters.size() == 1);
    CHECK(look.parameters[0].name == "glow");
    CHECK(look.parameters[0].range.high == 2.0);
}

TEST_CASE("errors are reported at the author's line, in JSON with the pass name") {
    const ShadertoyFiles files;
    const LoadedLook text =
        load_shadertoy_look(files.write("a.glsl",
                                        "// one\nvoid mainImage(out vec4 c, in vec2 p) {\n"
                                        "    c = vec5(1.0);\n}\n"),
                            {}, {});
    REQUIRE_FALSE(text.look.has_value());
    CHECK(files.told(text.look.error()).starts_with("a.glsl:3: error: "));
    const LoadedLook json = files.load_json(
        json_pass("common", "", "float a = 1.0;") + "," +
        json_pass("image", "4dfGRr",
                  "#define A \\\\\\n 1.0\\nvoid mainImage(out vec4 c, in vec2 p) {\\n c = b; }"));
    REQUIRE_FALSE(json.look.has_value());
    CHECK(files.told(json.look.error()).starts_with("a.json/Image:4: error: 'b'"));
}

TEST_CASE("a Common pass precedes every other pass") {
    const ShadertoyFiles files;
    const Look look = files.look_of_json(
        json_pass("image", "4dfGRr", "void mainImage(out vec4 c, in vec2 p) { c = vec4(one()); }") +
        "," + json_pass("common", "", "float one() { return 1.0; }") + "," +
        json_pass("buffer", "4dXGR8",
                  "void mainImage(out vec4 c, in vec2 p) { c = vec4(one()); }"));
    CHECK(names_of(look) == "Buffer A, Image");
}

TEST_CASE("a texture is an image parameter with a default, shared by all its readers") {
    const ShadertoyFiles files;
    const std::string noise = "/media/a/f735bee5b64ef98879dc618b016ecf79.png";
    const Look look = files.look_of_json(
        json_pass("buffer", "4dXGR8", reads_0, json_input(0, "texture", "", noise)) + "," +
        json_pass("image", "4dfGRr", reads_0, json_input(0, "texture", "", noise)));
    REQUIRE(look.parameters.size() == 1);
    const Parameter& picture = look.parameters[0];
    CHECK(picture.name == "rgba_noise_256");
    CHECK(picture.control == Control::image);
    CHECK(picture.initial.path == "pattern:noise");
    CHECK(picture.bindings == std::vector<Binding>{{0, "iChannel0"}, {1, "iChannel0"}});
    CHECK(input_in(look, "Image", "iChannel0").name == "rgba_noise_256");
}

TEST_CASE("a texture next to the shader file is used") {
    const ShadertoyFiles files;
    const auto beside = files.write("cat.png", "not looked into");
    const Look look = files.look_of_json(
        json_pass("image", "4dfGRr", reads_0, json_input(0, "texture", "", "/media/a/cat.png")));
    CHECK(look.parameters[0].initial.path == beside.string());
}

TEST_CASE("cube maps, volumes, keyboard and videos are supported") {
    const ShadertoyFiles files;
    const Look look = files.look_of_json(
        json_pass("image", "4dfGRr",
                  "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, vec3(p, 1.0)) + "
                  "texture(iChannel1, vec3(p, 1.0)) + texelFetch(iChannel2, ivec2(65, 0), 0) + "
                  "texture(iChannel3, p); }",
                  json_input(0, "cubemap") + "," + json_input(1, "volume") + "," +
                      json_input(2, "keyboard") + "," + json_input(3, "video")));
    CHECK(input_in(look, "Image", "iChannel0").from == Input::From::image);
    CHECK(input_in(look, "Image", "iChannel1").from == Input::From::image);
    CHECK(input_in(look, "Image", "iChannel2").from == Input::From::keyboard);
    CHECK(input_in(look, "Image", "iChannel3").from == Input::From::source);
    CHECK(look.driven_by == Driver::picture);
    CHECK(reads_keys(look));
    REQUIRE(look.images.size() == 2);
    CHECK(look.images[0].shape == PictureShape::cube);
    CHECK(look.images[1].shape == PictureShape::volume);
    CHECK(find_parameter(look, look.images[0].name)->initial.path == "solid:sky");
    CHECK(find_parameter(look, look.images[1].name)->initial.path == "solid:noise-volume");
}

TEST_CASE("music is the user's signal, as spectrum and wave") {
    const ShadertoyFiles files;
    const Look look = files.look_of_json(
        json_pass("image", "4dfGRr", reads_0, json_input(0, "musicstream", "", "https://a/b")));
    const Input& music = input_in(look, "Image", "iChannel0");
    CHECK(music.from == Input::From::sound);
    CHECK(music.sound == SoundTexture{SoundTexture::Holds::analyser, 512});
    CHECK(look.driven_by == Driver::signal);
    CHECK(look.default_signal.has_value());
}

TEST_CASE("Cube A is drawn after the buffers as six faces, and read as a cube map") {
    const ShadertoyFiles files;
    const std::string cube_main =
        "void mainCubemap(out vec4 c, in vec2 p, in vec3 from, in vec3 seen) { c = vec4(seen, "
        "1.0); }";
    const std::string reads_cube =
        "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, vec3(1.0)); }";
    const Look look = files.look_of_json(
        json_pass("image", "4dfGRr", reads_cube, json_input(0, "cubemap", "4dX3Rr")) + "," +
        json_pass("cubemap", "4dX3Rr", cube_main) + "," +
        json_pass("buffer", "4dXGR8", reads_cube, json_input(0, "cubemap", "4dX3Rr")));
    CHECK(names_of(look) == "Buffer A, Cube A, Image");
    CHECK(input_in(look, "Image", "iChannel0").reference() == "Cube A");
    CHECK(input_in(look, "Buffer A", "iChannel0").reference() == "Cube A@1");
    CHECK(look.passes[1].size[0].factor == 6.0 * look.passes[1].size[1].factor);
}

TEST_CASE("unsupported passes and missing buffers give warnings, and the rest loads") {
    const ShadertoyFiles files;
    const LoadedLook loaded = files.load_json(
        json_pass("image", "4dfGRr", reads_0, json_input(0, "buffer", "4dXGR8")) + ",\n" +
        json_pass("sound", "", "vec2 mainSound(float t) { return vec2(0.0); }"));
    CHECK(loaded.look.has_value());
    CHECK(
        files.told(loaded.warnings) ==
        "a.json/Sound:1: warning: Sound passes aren't supported; this pass is ignored\n"
        "a.json:1: warning: iChannel0 of 'Image' reads Buffer A, which is missing; it is black\n");
}

TEST_CASE("a folder of files is one shader: passes by name, channels in the order of buffers") {
    const ShadertoyFiles files;
    files.write("common.glsl", "const float half_of = 0.5;\n");
    files.write("Buffer A.glsl",
                "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n");
    files.write("buf_b.glsl",
                "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n");
    const auto image = files.write("Image.glsl",
                                   "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel1, "
                                   "p) * half_of + texture(iChannel2, p); }\n");
    CHECK(is_shadertoy_file(image));
    const Look look = files.good(load_look(image, {}));
    CHECK(names_of(look) == "Buffer A, Buffer B, Image");
    CHECK(input_in(look, "Buffer A", "iChannel0").reference() == "Buffer A@1");
    CHECK(input_in(look, "Buffer B", "iChannel0").reference() == "Buffer A");
    CHECK(input_in(look, "Image", "iChannel1").reference() == "Buffer B");
    CHECK(input_in(look, "Image", "iChannel2").from == Input::From::image);
    CHECK(look.files.size() == 4);
}

TEST_CASE("files with a common prefix form a shader if a folder has several") {
    const ShadertoyFiles files;
    files.write("fire_bufferA.frag", plain);
    files.write("rain_bufferA.frag", plain);
    const Look look =
        files.good(load_shadertoy_look(files.write("fire_image.frag", plain), {}, {}));
    CHECK(names_of(look) == "Buffer A, Image");
    CHECK(look.passes[0].fragment.file.filename() == "fire_bufferA.frag");
}

TEST_CASE("a Shadertoy file is recognised by its content") {
    const ShadertoyFiles files;
    CHECK(is_shadertoy_file(files.write("a.json", "{\"renderpass\": []}")));
    CHECK_FALSE(is_shadertoy_file(files.write("b.json", "{\"format\": \"afterglow-preset\"}")));
    CHECK_FALSE(is_shadertoy_file(files.write("look.json", "{\"renderpass\": []}")));
    CHECK(is_shadertoy_file(files.write("a.txt", plain)));
    CHECK_FALSE(is_shadertoy_file(files.write("b.txt", "mainImage is a name")));
    CHECK_FALSE(is_shadertoy_file(
        files.write("b.frag", std::string(plain) + "\nvoid main() { mainImage(a, b); }")));
}

TEST_CASE("constants with a range are parameters, in a common text for all passes") {
    const ShadertoyFiles files;
    files.write("Common.glsl", "#define GAIN 0.5  // @range 0 2\n");
    files.write("Buffer A.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(GAIN); }\n");
    const auto image = files.write("Image.glsl",
                                   "const int N = 3;  // @range 1 9\n"
                                   "uniform float own = 0.25;  // @range 0 1\n"
                                   "void mainImage(out vec4 c, in vec2 p) {\n"
                                   "    float taps[N];\n"
                                   "    c = vec4(taps[0] + own) * GAIN;\n"
                                   "}\n");
    const Values values{{"N", 5.0}, {"GAIN", 1.5}, {"own", 0.75}};
    const Look look = files.good(load_shadertoy_look(image, {}, {nullptr, nullptr, &values}));
    REQUIRE(parameter_names(look) == std::vector<std::string>{"GAIN", "N", "own"});
    CHECK(find_parameter(look, "GAIN")->bindings == std::vector<Binding>{{0, "GAIN"}, {1, "GAIN"}});
    CHECK(find_parameter(look, "GAIN")->initial == Value(0.5));
    CHECK_FALSE(find_parameter(look, "own")->is_constant);
    CHECK(look.constants == Values{{"GAIN", 1.5}, {"N", 5.0}});
    CHECK(look.passes[0].fragment.text->find("#define GAIN 1.5  // @range") != std::string::npos);
    CHECK(look.passes[1].fragment.text->find("const int N = 5;") != std::string::npos);
}

TEST_CASE("a constant and a uniform with the same name are an error at the uniform's line") {
    const ShadertoyFiles files;
    files.write("Buffer A.glsl",
                "#define GAIN 0.5  // @range 0 2\n"
                "void mainImage(out vec4 c, in vec2 p) { c = vec4(GAIN); }\n");
    const auto image = files.write("Image.glsl",
                                   "uniform float GAIN;\n"
                                   "void mainImage(out vec4 c, in vec2 p) { c = vec4(GAIN); }\n");
    const LoadedLook loaded = load_shadertoy_look(image, {}, {});
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(files.told(loaded.look.error())
              .starts_with("Image.glsl:1: error: 'GAIN' is a uniform here but a constant "
                           "elsewhere (at Buffer A.glsl:1)"));
}
