#include "glsl/parameters/parameters.h"

#include "glsl/parameters/builtins.h"
#include "glsl/shader_texts.h"

#include <doctest/doctest.h>

namespace {
Result<std::vector<Parameter>> parameters_of(const Look& look) {
    Diagnostics warnings;
    return find_parameters(look, nullptr, warnings);
}

std::string errors_of(const Look& look) {
    const auto parameters = parameters_of(look);
    REQUIRE_FALSE(parameters.has_value());
    return to_string(parameters.error());
}

Input input_of(const std::string& uniform) {
    Input input;
    input.uniform = uniform;
    input.name = "main";
    return input;
}

Look two_passes(const std::string& first, const std::string& second) {
    Look look;
    look.passes = {pass_of("one", fragment_with(first, "one.frag")),
                   pass_of("two", fragment_with(second, "two.frag"))};
    return look;
}

std::vector<std::string> names_of(const Result<std::vector<Parameter>>& parameters) {
    if (!parameters)
        FAIL(to_string(parameters.error()));
    std::vector<std::string> names;
    for (const Parameter& parameter : *parameters)
        names.push_back(parameter.name);
    return names;
}

using Names = std::vector<std::string>;
}  // namespace

TEST_CASE("parameters are in declaration order, vertex shader first") {
    Look look = two_passes("uniform float b, a;", "uniform float c, b;");
    look.passes[0].vertex =
        stage_of("one.vert",
                 "#version 410 core\nuniform float z;\nvoid main() { gl_Position = vec4(z); }\n");
    CHECK(names_of(parameters_of(look)) == Names{"z", "b", "a", "c"});
}

TEST_CASE("a uniform of several passes and stages is one parameter") {
    Look look = two_passes("uniform float gain;", "uniform float gain = 0.5;  // @range 0 3");
    look.passes[0].vertex = stage_of("one.vert",
                                     "#version 410 core\nuniform float gain; // @unit dB\nvoid "
                                     "main() { gl_Position = vec4(gain); }\n");
    const auto parameters = parameters_of(look);
    REQUIRE(names_of(parameters) == Names{"gain"});
    const Parameter& gain = parameters->front();
    CHECK(gain.bindings == std::vector<Binding>{{0, "gain"}, {1, "gain"}});
    CHECK(gain.initial == Value(0.5));
    CHECK(gain.range == Range{0.0, 3.0, 0.0});
    CHECK(gain.unit == "dB");
    CHECK(gain.declared == Location{"one.vert", 2});
}

TEST_CASE("a uniform without a default starts at zero") {
    CHECK(parameters_of(look_with("uniform vec3 a;"))->front().initial == Value({0.0, 0.0, 0.0}));
    CHECK(parameters_of(look_with("uniform mat3x2 a;"))->front().initial ==
          Value(std::vector<double>(6, 0.0)));
}

TEST_CASE("conflicting declarations are reported at the second one") {
    CHECK(errors_of(two_passes("uniform float gain;", "\nuniform vec2 gain;")) ==
          "two.frag:3: error: 'gain' is a vec2 here but a float in another pass (at one.frag:2)\n");
    CHECK(errors_of(two_passes("uniform float gain = 1.0;", "uniform float gain = 2.0;")) ==
          "two.frag:2: error: 'gain' is 2 here but 1 in another pass (at one.frag:2)\n");
    CHECK(errors_of(two_passes("uniform float gain; // @range 0 1",
                               "uniform float gain; // @range 0 2")) ==
          "two.frag:2: error: @range of 'gain' differs from another declaration (at "
          "one.frag:2)\n");
    CHECK(names_of(parameters_of(two_passes("uniform float gain; // @range 0 1",
                                            "uniform float gain; // @range 0.0 1.0"))) ==
          Names{"gain"});
}

TEST_CASE("built-in uniforms are not parameters, and their type is checked") {
    CHECK(names_of(parameters_of(look_with(
              "uniform float u_time, u_time_delta;\nuniform int u_frame, u_samples;\n"
              "uniform vec2 u_resolution, u_output_resolution, u_source_resolution, u_mouse;\n"
              "uniform mat4 u_view;\nuniform float mine;"))) == Names{"mine"});
    CHECK(errors_of(look_with("\nuniform int u_time;")) ==
          "a.frag:3: error: Afterglow sets 'u_time', so it must be a float, got an int\n");
    CHECK(errors_of(look_with("uniform vec2 u_mouse[2];")) ==
          "a.frag:2: error: Afterglow sets 'u_mouse', so it must be a vec2, got a vec2[2]\n");
    for (const BuiltInUniform& uniform : own_built_ins())
        CHECK_MESSAGE(find_builtin_uniform(uniform.name), uniform.name);
}

TEST_CASE("a uniform set by a pass has no slider there, but keeps it elsewhere") {
    Look look = two_passes("uniform vec2 direction;", "uniform vec2 direction;");
    look.passes[0].set["direction"] = Value({1.0, 0.0});
    const auto parameters = parameters_of(look);
    REQUIRE(names_of(parameters) == Names{"direction"});
    CHECK(parameters->front().bindings == std::vector<Binding>{{1, "direction"}});
    look.passes[1].set["direction"] = Value({0.0, 1.0});
    CHECK(names_of(parameters_of(look)).empty());
}

TEST_CASE("rename gives two passes of one shader separate parameters") {
    Look look = two_passes("uniform float sigma = 2.0;", "uniform float sigma = 2.0;");
    look.passes[1].rename["sigma"] = "wide_sigma";
    const auto parameters = parameters_of(look);
    REQUIRE(names_of(parameters) == Names{"sigma", "wide_sigma"});
    CHECK(parameters->back().bindings == std::vector<Binding>{{1, "sigma"}});
    CHECK(parameters->back().label == "Wide sigma");
}

TEST_CASE("look.json must not name anything that no shader of the pass declares") {
    Look look = look_with("uniform float decay;\nuniform sampler2D image;\nuniform float u_time;");
    look.passes[0].inputs.push_back(input_of("image"));
    Pass& pass = look.passes[0];
    const Pass good = pass;
    pass.set["dacay"] = Value(1.0);
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main': 'set' names 'dacay', which no shader of "
          "the pass declares (did you mean 'decay'?)\n");
    pass = good;
    pass.rename["nothing"] = "x";
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main': 'rename' names 'nothing', which no "
          "shader of the pass declares\n");
    pass = good;
    pass.inputs.push_back(input_of("picture"));
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main': 'inputs' names 'picture', which no "
          "shader of the pass declares\n");
    pass = good;
    pass.inputs.push_back(input_of("decay"));
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main': input 'decay' must be a sampler, got a float\n");
    pass = good;
    pass.set["decay"] = Value({1.0, 2.0});
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main': wrong number of values for 'decay' in 'set'; a float "
          "needs 1, got 2\n");
    pass = good;
    pass.set["u_time"] = Value(1.0);
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main': 'set' names 'u_time', which Afterglow sets "
          "automatically\n");
    pass = good;
    pass.repeat = "tims";
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main' repeats 'tims' times, but no shader declares 'tims'\n");
    pass = good;
    pass.converge = Count("enogh");
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main' converges after 'enogh' samples, but no shader declares "
          "'enogh'\n");
}

TEST_CASE("an orbit adds parameters for the matrices that shaders declare") {
    Look look = look_with("uniform mat4 u_view;\nuniform mat4 u_camera;\nuniform float mine;");
    CHECK(names_of(parameters_of(look)) == Names{"mine"});
    look.has_orbit = true;
    CHECK(names_of(parameters_of(look)) ==
          Names{"mine", "orbit_turn", "orbit_azimuth", "orbit_elevation", "orbit_distance"});
    look = look_with("uniform mat4 u_view;\nuniform float orbit_turn;");
    look.has_orbit = true;
    CHECK(errors_of(look) ==
          "a.frag:3: error: 'orbit_turn' is reserved for a parameter of the orbit\n");
    look = look_with("uniform float mine;");
    look.has_orbit = true;
    look.manifest = "look.json";
    CHECK(errors_of(look) ==
          "look.json: error: the look has an 'orbit', but no shader declares 'uniform mat4 "
          "u_view' or 'uniform mat4 u_camera'\n");
}

TEST_CASE("a sampler2D without input is an image parameter, and any other sampler is an error") {
    const auto parameters =
        parameters_of(look_with("uniform sampler2D paper;  // @label \"Paper\""));
    REQUIRE(names_of(parameters) == Names{"paper"});
    CHECK(parameters->front().control == Control::image);
    CHECK(parameters->front().label == "Paper");
    CHECK(parameters->front().initial == Value::of_path(""));
    CHECK(errors_of(look_with("uniform samplerCube sky;")) ==
          "a.frag:2: error: 'sky' has no input in pass 'main'; only a sampler2D can be a picture "
          "parameter\n");
}

TEST_CASE("a uniform without control gives one warning with the reason") {
    const std::string uniforms = "uniform float table[3];\nuniform double d;\nuniform float ok;";
    Look look = look_with(uniforms);
    look.passes.push_back(look.passes.front());
    Diagnostics warnings;
    CHECK(names_of(find_parameters(look, nullptr, warnings)) == Names{"ok"});
    CHECK(to_string(warnings) ==
          "a.frag:2: warning: 'table' (float[3]) is an array; only single values have controls\n"
          "a.frag:3: warning: 'd' (double) is a double; use float to get a control\n");
}

TEST_CASE("a uniform in an inactive branch has no control") {
    CHECK(names_of(parameters_of(look_with("#if 0\nuniform float gone;  // @nonsense\n#endif\n"
                                           "uniform float here;"))) == Names{"here"});
    const auto parameters =
        parameters_of(look_with("#ifdef NEVER\nuniform float a; // @range 0 9\n#else\n"
                                "uniform float a; // @range 0 2\n#endif"));
    REQUIRE(names_of(parameters) == Names{"a"});
    CHECK(parameters->front().range == Range{0.0, 2.0, 0.0});
}

TEST_CASE("errors of all passes are reported together, each once") {
    Look look = two_passes("float x = y;", "uniform float a; // @rnage 0 1");
    look.passes.push_back(look.passes.back());
    CHECK(errors_of(look) ==
          "one.frag:2: error: 'y' is undeclared\n"
          "two.frag:2: error: unknown annotation '@rnage' (did you mean '@range'?)\n");
}

TEST_CASE("a pass that draws points needs a vertex shader") {
    Look look = look_with("");
    look.passes[0].draw = Draw::points;
    CHECK(errors_of(look) ==
          "look.json:7: error: pass 'main' draws points and needs a vertex shader\n");
}

TEST_CASE("a cache does not change the parameters") {
    CheckCache cache;
    Diagnostics warnings;
    const Look look = two_passes("uniform float a = 0.5;", "uniform float b; // @range 1 2");
    const auto first = find_parameters(look, &cache, warnings);
    CHECK(first == parameters_of(look));
    CHECK(find_parameters(look, &cache, warnings) == first);
}

TEST_CASE("a look without passes has no parameters") {
    CHECK(names_of(parameters_of(Look{})).empty());
}
