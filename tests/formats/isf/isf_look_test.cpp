#include "formats/isf/isf_folder.h"
#include "model/plan/plan.h"

#include <algorithm>

namespace {
const std::string filter_input = R"({"NAME": "inputImage", "TYPE": "image"})";

const Input* find_input(const Pass& pass, const std::string& uniform) {
    const auto found = std::ranges::find(pass.inputs, uniform, &Input::uniform);
    return found == pass.inputs.end() ? nullptr : &*found;
}
}  // namespace

TEST_CASE("a generator has no input and is not driven") {
    const IsfFolder folder;
    const Look look = folder.look(R"("DESCRIPTION": "All red", "CREDIT": "me")", draws_red);
    CHECK(look.driven_by == Driver::nothing);
    CHECK(look.name == "a");
    CHECK(look.id == "a.fs");
    CHECK(look.about == "All red");
    CHECK(look.author == "me");
    CHECK(look.output == Encoding::display);
    REQUIRE(look.passes.size() == 1);
    CHECK(look.passes[0].name == "picture");
    CHECK(look.passes[0].format == Format::rgba8);
}

TEST_CASE("inputImage of a filter and startImage of a transition are the source") {
    const IsfFolder folder;
    const Look filter = folder.look("\"INPUTS\": [" + filter_input + "]",
                                    "void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }\n");
    CHECK(filter.driven_by == Driver::picture);
    CHECK(filter.source_encoding == Encoding::display);
    CHECK(filter.parameters.empty());
    REQUIRE(find_input(filter.passes[0], "inputImage"));
    CHECK(find_input(filter.passes[0], "inputImage")->from == Input::From::source);

    const Look transition = folder.look(
        R"("INPUTS": [{"NAME": "startImage", "TYPE": "image"}, {"NAME": "endImage", "TYPE": "image"},
           {"NAME": "progress", "TYPE": "float"}])",
        "void main() { gl_FragColor = mix(IMG_THIS_PIXEL(startImage), IMG_THIS_PIXEL(endImage),"
        " progress); }\n");
    CHECK(find_input(transition.passes[0], "startImage")->from == Input::From::source);
    REQUIRE(find_parameter(transition, "endImage"));
    CHECK(find_parameter(transition, "endImage")->control == Control::image);
    const std::string& other = find_parameter(transition, "endImage")->initial.path;
    CHECK(other.starts_with("pattern:"));
    CHECK(other != transition.default_source);
}

TEST_CASE("an audio shader is driven by a signal, and its inputImage is a parameter") {
    const IsfFolder folder;
    const Look look = folder.look(
        "\"INPUTS\": [" + filter_input +
            R"(, {"NAME": "wave", "TYPE": "audio", "MAX": 64}, {"NAME": "tones", "TYPE": "audioFFT"}])",
        "void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) + IMG_THIS_PIXEL(wave) +"
        " IMG_THIS_PIXEL(tones); }\n");
    CHECK(look.driven_by == Driver::signal);
    CHECK(look.default_signal.has_value());
    REQUIRE(find_parameter(look, "inputImage"));
    CHECK(find_parameter(look, "inputImage")->control == Control::image);
    const Input* wave = find_input(look.passes[0], "wave");
    REQUIRE(wave);
    CHECK(wave->from == Input::From::sound);
    CHECK(wave->sound == SoundTexture{SoundTexture::Holds::wave, 64});
    CHECK(find_input(look.passes[0], "tones")->sound ==
          SoundTexture{SoundTexture::Holds::spectrum, 256});
}

TEST_CASE(
    "a pass reads earlier passes of its frame, and later persistent ones of the previous frame") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("PASSES": [{"TARGET": "first", "PERSISTENT": true}, {"TARGET": "second"},
                      {"TARGET": "third", "PERSISTENT": true}, {}])",
        "void main() {\n"
        "  if (PASSINDEX == 0) gl_FragColor = IMG_THIS_PIXEL(first) + IMG_THIS_PIXEL(third);\n"
        "  else if (PASSINDEX == 1) gl_FragColor = IMG_THIS_PIXEL(first) + "
        "IMG_THIS_PIXEL(second);\n"
        "  else gl_FragColor = IMG_THIS_PIXEL(second);\n}\n");
    REQUIRE(look.passes.size() == 4);
    CHECK(look.passes[0].name == "first");
    CHECK(look.passes[3].name == "picture");
    CHECK(find_input(look.passes[0], "first")->reference() == "first@1");
    CHECK(find_input(look.passes[0], "third")->reference() == "third@1");
    CHECK(find_input(look.passes[1], "first")->reference() == "first");
    CHECK_FALSE(find_input(look.passes[1], "second"));  // empty so far
    CHECK(find_input(look.passes[3], "second")->reference() == "second");
    CHECK(look.passes[3].inputs.size() == 1);
    CHECK(look.settle_frames > 1);
}

TEST_CASE("parameters of a shader form one group, with readable labels") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("INPUTS": [{"NAME": "blurAmount", "TYPE": "float"}, {"NAME": "x2", "TYPE": "float",
           "LABEL": "Twice X"}], "PASSES": [{"TARGET": "a"}, {}])",
        "void main() { gl_FragColor = vec4(PASSINDEX == 0 ? x2 : blurAmount); }\n");
    REQUIRE(look.parameters.size() == 2);
    CHECK(look.parameters[0].label == "Blur amount");
    CHECK(look.parameters[1].label == "Twice X");
    CHECK(heading_of(look, look.parameters[0]) == heading_of(look, look.parameters[1]));
}

TEST_CASE("inputs and targets may have names that became reserved") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("INPUTS": [{"NAME": "sample", "TYPE": "float"}], "PASSES": [{"TARGET": "buffer"}, {}])",
        "void main() { gl_FragColor = PASSINDEX == 0 ? vec4(sample) : IMG_THIS_PIXEL(buffer); }\n");
    REQUIRE(find_parameter(look, "sample"));
    CHECK(find_parameter(look, "sample")->bindings.size() == 1);
    REQUIRE(look.passes[1].inputs.size() == 1);
    CHECK(look.passes[1].inputs[0].name == "buffer");
}

TEST_CASE("inputs may be named like GLSL functions and keywords") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("INPUTS": [{"NAME": "texture", "TYPE": "image"}, {"NAME": "smooth", "TYPE": "float"},
                      {"NAME": "switch", "TYPE": "bool"}, {"NAME": "length", "TYPE": "float"}])",
        "void main() {\n"
        "  gl_FragColor = IMG_THIS_PIXEL(texture) + texture2D(texture, isf_FragNormCoord);\n"
        "  gl_FragColor += texture(texture, _texture_imgSize) * smooth;\n"
        "  gl_FragColor *= length + length(gl_FragCoord.xy);\n"
        "  if (switch) discard;\n}\n");
    for (const Parameter& parameter : look.parameters) {
        CAPTURE(parameter.name);
        CHECK(parameter.bindings.size() == 1);
    }
}

TEST_CASE("an invalid or reserved name is an error at its line") {
    const IsfFolder folder;
    CHECK(folder.refusal("\"INPUTS\": [\n{\"NAME\": \"while\", \"TYPE\": \"float\"}]", draws_red) ==
          "a.fs:2: error: 'while' isn't a valid GLSL identifier");
    CHECK(folder.refusal("\"PASSES\": [\n{\"TARGET\": \"IMG_SIZE\"}, {}]", draws_red) ==
          "a.fs:2: error: 'IMG_SIZE' is a reserved name in ISF");
}

TEST_CASE("every pass has alpha, and only persistent targets are kept when resized") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("PASSES": [{"TARGET": "a", "PERSISTENT": true}, {"TARGET": "b"}, {"WIDTH": 5}])",
        draws_red);
    for (const Pass& pass : look.passes) {
        CHECK(pass.has_alpha);
        CHECK(pass.keeps_when_resized == (pass.name == "a"));
    }
}

TEST_CASE("a parameter is bound to the passes whose branch reads it") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("INPUTS": [{"NAME": "gain", "TYPE": "float"}, {"NAME": "size", "TYPE": "float"},
                      {"NAME": "unused", "TYPE": "float"}],
           "PASSES": [{"TARGET": "a", "WIDTH": "$WIDTH*$size"}, {}])",
        "void main() { gl_FragColor = vec4(PASSINDEX == 1 ? gain : 0.0); }\n");
    CHECK(find_parameter(look, "gain")->bindings == std::vector<Binding>{{1, "gain"}});
    CHECK_FALSE(find_parameter(look, "size")->is_hidden);
    CHECK(find_parameter(look, "unused")->is_hidden);
}

TEST_CASE("sizes are expressions of picture and inputs, rounded down, at least one texel") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"x("INPUTS": [{"NAME": "part", "TYPE": "float", "MIN": 0, "MAX": 8, "DEFAULT": 3}],
           "PASSES": [{"TARGET": "a", "WIDTH": "$WIDTH/$part", "HEIGHT": "floor($HEIGHT/4.0)+0.9"},
                      {"TARGET": "b", "WIDTH": "$WIDTH/1000", "HEIGHT": 7},
                      {"TARGET": "c", "WIDTH": "max($WIDTH, $HEIGHT)", "FLOAT": true
}, {}])x",
        draws_red);
    const auto plan = plan_targets(look, {100, 50}, {}, {});
    REQUIRE(plan.has_value());
    CHECK(plan->targets[0].extent == Extent{33, 12});
    CHECK(plan->targets[1].extent == Extent{1, 7});
    CHECK(plan->targets[2].extent == Extent{100, 50});
    CHECK(plan->targets[2].format == Format::rgba32f);
    CHECK(plan->targets[3].extent == Extent{100, 50});
}

TEST_CASE("an invalid size expression is an error at its pass") {
    const IsfFolder folder;
    CHECK(
        folder.refusal("\"PASSES\": [\n{\"TARGET\": \"a\", \"WIDTH\": \"$WIDTH/\"}, {}]", draws_red)
            .starts_with("a.fs:2: error: size of pass 'a': "));
    CHECK(folder.refusal("\"PASSES\": [\n{\"TARGET\": \"a\", \"WIDTH\": \"$NONE\"}, {}]", draws_red)
              .find("unknown name '$NONE'") != std::string::npos);
}

TEST_CASE("a non-finite size is one texel, with a warning") {
    const IsfFolder folder;
    const LoadedLook loaded = folder.load(
        R"x("INPUTS": [{"NAME": "n", "TYPE": "float", "DEFAULT": 0}],
"PASSES": [{"TARGET": "a", "WIDTH": "$WIDTH / $n", "HEIGHT": "sqrt(0 - 1)"}, {}])x",
        "void main() { gl_FragColor = IMG_THIS_PIXEL(a); }\n");
    REQUIRE(loaded.look.has_value());
    const auto plan = plan_targets(*loaded.look, {640, 480}, {640, 480}, {});
    REQUIRE(plan.has_value());
    CHECK(plan->targets[0].extent == Extent{1, 1});
    const auto halved = plan_targets(*loaded.look, {640, 480}, {640, 480}, {{"n", Value(2.0)}});
    CHECK(halved->targets[0].extent == Extent{320, 1});
    CHECK(folder.told(loaded.warnings) ==
          "a.fs:2: warning: size of pass 'a': '$WIDTH / $n' isn't a finite number; 1 is used\n"
          "a.fs:2: warning: size of pass 'a': 'sqrt(0 - 1)' isn't a finite number; 1 is used");
}

TEST_CASE("shader errors are reported at the author's lines, once for all passes") {
    const IsfFolder folder;
    const std::string told =
        folder.refusal("\n\"PASSES\": [{\"TARGET\": \"a\"}, {}]\n",
                       "void main() {\n    gl_FragColor = vec4(nothing);\n}\n");
    CHECK(told.starts_with("a.fs:5: error: "));
    CHECK(told.find("nothing") != std::string::npos);
    CHECK(std::ranges::count(told, '\n') == 0);
}

TEST_CASE("a time-dependent shader settles for 60 frames, and a static one for one") {
    const IsfFolder folder;
    CHECK(folder.look("", draws_red).settle_frames == 1);
    CHECK(folder.look("", "void main() { gl_FragColor = vec4(TIME); }\n").settle_frames == 60);
    CHECK(folder.look(R"("PASSES": [{"TARGET": "a", "PERSISTENT": true}, {}])", draws_red)
              .settle_frames == 60);
    CHECK(
        folder.look(R"("INPUTS": [{"NAME": "wave", "TYPE": "audio"}])", draws_red).settle_frames ==
        60);
}

TEST_CASE(
    "of two passes with one target the later reads the earlier, and the next frame the later") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("PASSES": [{"TARGET": "t", "PERSISTENT": true}, {"TARGET": "t", "WIDTH": 5, "FLOAT": true}, {}])",
        "void main() { gl_FragColor = IMG_THIS_PIXEL(t); }\n");
    CHECK(pass_names(look) == std::vector<std::string>{"t", "t-2", "picture"});
    CHECK(find_input(look.passes[0], "t")->reference() == "t-2@1");
    CHECK(find_input(look.passes[1], "t")->reference() == "t");
    CHECK(find_input(look.passes[2], "t")->reference() == "t-2");
    // It is one target: settings of one of its passes apply to all.
    const auto plan = plan_targets(look, {100, 50}, {}, {});
    REQUIRE(plan.has_value());
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(plan->targets[i].extent == Extent{5, 50});
        CHECK(plan->targets[i].format == Format::rgba32f);
    }
}

TEST_CASE("a target may have any name, also that of the picture") {
    const IsfFolder folder;
    const Look look = folder.look(R"("PASSES": [{"TARGET": "picture"}, {}])",
                                  "void main() { gl_FragColor = IMG_THIS_PIXEL(picture); }\n");
    CHECK(pass_names(look) == std::vector<std::string>{"picture", "picture-2"});
    CHECK(find_input(look.passes[1], "picture")->reference() == "picture");
}

TEST_CASE("a last pass with a size is stretched over the picture") {
    const IsfFolder folder;
    const Look look = folder.look(
        R"("PASSES": [{"TARGET": "a"}, {"TARGET": "b", "WIDTH": "$WIDTH/4", "PERSISTENT": true}])",
        "void main() { gl_FragColor = IMG_THIS_PIXEL(b); }\n");
    CHECK(pass_names(look) == std::vector<std::string>{"a", "b", "picture"});
    const auto plan = plan_targets(look, {120, 60}, {}, {});
    REQUIRE(plan.has_value());
    CHECK(plan->targets[1].extent == Extent{30, 60});
    CHECK(plan->targets[2].extent == Extent{120, 60});
    const Look whole =
        folder.look(R"("PASSES": [{"WIDTH": " $WIDTH", "HEIGHT": "$HEIGHT"}])", draws_red);
    CHECK(pass_names(whole) == std::vector<std::string>{"picture"});
}

TEST_CASE("a vertex shader with the same name is used, and reports its own lines") {
    const IsfFolder folder;
    folder.write("a.vs",
                 "varying vec2 turned;\n"
                 "void main() { vv_vertShaderInit(); turned = isf_FragNormCoord.yx; }\n");
    const Look look = folder.look(
        "", "varying vec2 turned;\nvoid main() { gl_FragColor = vec4(turned, 0, 1); }\n");
    CHECK(look.passes[0].vertex.file == folder / "a.vs");
    CHECK(look.passes[0].draw == Draw::quad);
    folder.write("a.vs", "\nvoid main() { isf_vertShaderInit(); gl_Position = wrong; }\n");
    CHECK(folder.refusal("", draws_red).starts_with("a.vs:2: error: "));
}

TEST_CASE("a vertex shader that may appear later is watched") {
    const IsfFolder folder;
    const LoadedLook loaded = folder.load("", draws_red);
    CHECK(std::ranges::find(loaded.files, folder / "a.fs") != loaded.files.end());
    CHECK(std::ranges::find(loaded.files, folder / "a.vs") != loaded.files.end());
}

TEST_CASE("a missing import is black with a warning, and an existing one is an image") {
    const IsfFolder folder;
    const LoadedLook loaded = folder.load(
        "\"IMPORTED\": {\n\"there\": {\"PATH\": \"there.png\"},\n\"gone\": {\"PATH\": "
        "\"gone.png\"}}",
        "void main() { gl_FragColor = IMG_THIS_PIXEL(there) + IMG_THIS_PIXEL(gone); }\n");
    CHECK(folder.told(loaded.warnings) ==
          "a.fs:2: warning: can't find the picture 'there.png'; 'there' is black\n"
          "a.fs:3: warning: can't find the picture 'gone.png'; 'gone' is black");
    folder.write("there.png", "any");
    const LoadedLook again = folder.load();
    REQUIRE(again.look.has_value());
    REQUIRE(again.look->images.size() == 1);
    CHECK(again.look->images[0].file == folder / "there.png");
    CHECK(find_input(again.look->passes[0], "there")->from == Input::From::image);
}

TEST_CASE("a uniform without an input gives a warning") {
    const IsfFolder folder;
    const LoadedLook loaded =
        folder.load("", "uniform float own;\nvoid main() { gl_FragColor = vec4(own); }\n");
    REQUIRE(loaded.look.has_value());
    CHECK(folder.told(loaded.warnings) ==
          "a.fs:2: warning: 'own' isn't an input in the header; it stays 0");
}

TEST_CASE("a .fs file without an ISF header is an error") {
    const IsfFolder folder;
    const auto file = folder.write("a.fs", "float main;\n");
    CHECK_FALSE(is_isf_file(file));
    CHECK(is_foreign_look(file));
    CHECK(is_isf_file(folder.write("b.fs", "/*{}*/")));
    CHECK_FALSE(is_isf_file(folder / "none.fs"));
    const LoadedLook loaded = folder.load();
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(folder.told(loaded.look.error()).starts_with("a.fs:1: error: not an ISF shader: "));
}

TEST_CASE("an empty, binary or truncated file is an error with a reason") {
    const IsfFolder folder;
    for (const std::string& text :
         {std::string(), std::string("/*{\0}*/", 7), std::string("/*{\"A")}) {
        folder.write("a.fs", text);
        const LoadedLook loaded = folder.load();
        REQUIRE_FALSE(loaded.look.has_value());
        CHECK(folder.told(loaded.look.error()).starts_with("a.fs"));
    }
}

TEST_CASE("a constant with a range is a parameter in addition to the inputs") {
    const IsfFolder folder;
    const std::string code =
        "#define STEPS 8  // @range 1 64 @label \"Steps\"\n"
        "void main() { float a = level; for (int i = 0; i < STEPS; ++i) a += 0.1;"
        " gl_FragColor = vec4(a); }\n";
    const char* input = R"("INPUTS": [{"NAME": "level", "TYPE": "float"}])";
    const Look plain = folder.look(input, code);
    CHECK(parameter_names(plain) == std::vector<std::string>{"level", "STEPS"});
    CHECK(find_parameter(plain, "STEPS")->label == "Steps");
    CHECK_FALSE(find_parameter(plain, "STEPS")->is_hidden);
    const Values values{{"STEPS", 12.0}};
    const LoadedLook turned = load_look(folder / "a.fs", {}, {nullptr, nullptr, &values});
    REQUIRE(turned.look.has_value());
    CHECK(turned.look->passes[0].fragment.text->find("#define STEPS 12 ") != std::string::npos);
    CHECK(folder.refusal(input, "#define level 8  // @range 1 9\n" + code)
              .find("'level' is already the name of another parameter") != std::string::npos);
}

TEST_CASE("a cube input is an image parameter that is sampled by direction") {
    const IsfFolder folder;
    const Look look =
        folder.look(R"("INPUTS": [{"NAME": "room", "TYPE": "cube", "LABEL": "The room"}])",
                    "void main() { gl_FragColor = textureCube(room, vec3(1.0, 0.0, 0.0)); }\n");
    CHECK(look.driven_by == Driver::nothing);
    const Parameter* room = find_parameter(look, "room");
    REQUIRE(room);
    CHECK(room->label == "The room");
    CHECK(room->control == Control::image);
    CHECK_FALSE(room->is_hidden);
    CHECK(room->initial.path == "solid:sky");
    REQUIRE(look.images.size() == 1);
    CHECK(look.images[0].name == "room");
    CHECK(look.images[0].shape == PictureShape::cube);
}
