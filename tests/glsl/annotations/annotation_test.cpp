#include "glsl/annotations/annotation.h"

#include "glsl/annotations/guess.h"
#include "glsl/parameters/parameters.h"
#include "glsl/shader_texts.h"
#include "glsl/text/declarations.h"

#include <doctest/doctest.h>

#include <numbers>

namespace {
Parameter parameter_of(const std::string& lines) {
    Diagnostics warnings;
    const auto parameters = find_parameters(look_with(lines), nullptr, warnings);
    if (!parameters)
        FAIL(to_string(parameters.error()));
    REQUIRE(parameters->size() == 1);
    return parameters->front();
}

std::string error_of(const std::string& lines) {
    Diagnostics warnings;
    const auto parameters = find_parameters(look_with(lines), nullptr, warnings);
    REQUIRE_FALSE(parameters.has_value());
    return to_string(parameters.error());
}

std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    for (const Declaration& declaration : find_declarations(text))
        names.push_back(declaration.name + ':' + std::to_string(declaration.line));
    return names;
}

using Names = std::vector<std::string>;
}  // namespace

TEST_CASE("a comment after a uniform describes its control") {
    const Parameter decay = parameter_of(
        "uniform float decay = 0.92;  // @range 0.5 0.999 0.01 @limit 0 1 @label \"Glow kept\"\n"
        "  // @unit \"per 1/60 s\"  @group \"Phosphor\"\n"
        "  // @help \"How much light is left,\n"
        "  //        \\\"a sixtieth\\\" later.\"\n"
        "  // @identity 1 @was persistence @hidden");
    CHECK(decay.range == Range{0.5, 0.999, 0.01});
    CHECK(decay.limit == Limit{0.0, 1.0});
    CHECK(decay.label == "Glow kept");
    CHECK(decay.unit == "per 1/60 s");
    CHECK(decay.group == "Phosphor");
    CHECK(decay.help == "How much light is left, \"a sixtieth\" later.");
    CHECK(decay.identity == Value(1.0));
    CHECK(decay.was == "persistence");
    CHECK(decay.is_hidden);
    CHECK(decay.initial == Value(0.92));
    CHECK(decay.declared == Location{"a.frag", 2});
}

TEST_CASE("previous labels of items are in the order of the items") {
    const Parameter parameter = parameter_of(
        "uniform int a = 1;  // @items_was \"\" \"Soft\" @items \"Clamp\" \"Reinhard\" \"ACES\"");
    CHECK(parameter.items ==
          std::vector<Item>{{0, "Clamp", ""}, {1, "Reinhard", "Soft"}, {2, "ACES", ""}});
}

TEST_CASE("items can have a note and a colour") {
    const Parameter parameter = parameter_of(
        "uniform int a = 1;  // @items \"A\" \"B\" @items_note \"\" \"27 ms\" @items_color \"\" "
        "\"#ff00ff\"");
    CHECK(parameter.items[0] == Item{0, "A"});
    CHECK(parameter.items[1].note == "27 ms");
    CHECK(parameter.items[1].color == std::array{1.0, 0.0, 1.0});
}

TEST_CASE("annotations select the control") {
    CHECK(parameter_of("uniform vec3 a = vec3(0.2, 1, 0.3);  // @color").control == Control::color);
    CHECK(parameter_of("uniform vec2 a;  // @point").control == Control::point);
    const Parameter angle = parameter_of("uniform float a;  // @angle");
    CHECK(angle.control == Control::angle);
    CHECK(angle.range == Range{-std::numbers::pi, std::numbers::pi, 0.0});
    CHECK(parameter_of("uniform float a = 2.0; // @range 0.1 16 @scale log").scale ==
          Scale::logarithmic);
    const Parameter list =
        parameter_of("uniform int a = 1;  // @items \"Clamp\" \"Reinhard\" \"ACES\"");
    CHECK(list.control == Control::list);
    CHECK(list.items == std::vector<Item>{{0.0, "Clamp"}, {1.0, "Reinhard"}, {2.0, "ACES"}});
    CHECK(list.range == Range{0.0, 2.0, 1.0});
}

TEST_CASE("an expression continues up to the next annotation outside quotes") {
    const Parameter list = parameter_of(
        "uniform int a = 1;  // @when a==\"Two @ words\" || a  > 2\n"
        "  // @items \"One\" \"Two @ words\" \"Three\" @random no");
    CHECK(list.when == "a==\"Two @ words\" || a > 2");
    CHECK(list.items.size() == 3);
    CHECK(list.is_fixed_in_random);
}

TEST_CASE("a decay has a half-life scale unless its author chooses another one") {
    const std::string decay = "uniform float a = 0.9;  // @range 0.5 0.999 @unit \"per 1/60 s\"";
    CHECK(parameter_of(decay).scale == Scale::half_life);
    CHECK(parameter_of(decay + " @scale linear").scale == Scale::linear);
    CHECK(parameter_of("uniform float a = 0.9;  // @range 0 1 @scale half-life").scale ==
          Scale::half_life);
    CHECK(parameter_of("uniform float a = 0.9;  // @range 0 1").scale == Scale::linear);
}

TEST_CASE("components of a vector are named by the author or by axis") {
    const Parameter fade = parameter_of(
        "uniform vec3 fade_color = vec3(1.0);  // @range 0 4  @parts \"Red\" \"Green\" \"Blue\"");
    CHECK(fade.control == Control::slider);  // although its name suggests a colour
    CHECK(component_label(fade, 0) == "Red");
    CHECK(component_label(fade, 2) == "Blue");
    const Parameter offset = parameter_of("uniform vec4 shift;");
    CHECK(component_label(offset, 1) == "y");
    CHECK(component_label(offset, 3) == "w");
}

TEST_CASE("block comments and prose before the first annotation are allowed") {
    CHECK(parameter_of("uniform float a; /* how bright\n * @range 1 2\n * @unit px */").range ==
          Range{1.0, 2.0, 0.0});
    CHECK(parameter_of("uniform float a;  // it's 5\" wide, @range 1 2").range ==
          Range{1.0, 2.0, 0.0});
    CHECK(parameter_of("uniform float a;  // how bright\n// @range 1 2").range ==
          Range{1.0, 2.0, 0.0});
}

TEST_CASE("a comment on its own line belongs to the uniform only if it starts with an annotation") {
    const Parameter a = parameter_of(
        "// @range 5 6\nuniform float a;  // @range 1 2\n// the next part, not @hidden\n// @unit "
        "px");
    CHECK(a.range == Range{1.0, 2.0, 0.0});
    CHECK(a.unit.empty());
    CHECK_FALSE(a.is_hidden);
}

TEST_CASE("declarations are found in every GLSL syntax") {
    CHECK(names_in("uniform float a = 1.0, b = f(2.0, 3.0),\n  c[3];") ==
          Names{"a:1", "b:1", "c:2"});
    CHECK(names_in("layout(location = 3) uniform highp vec3\n  a;") == Names{"a:2"});
    CHECK(names_in("uniform struct S { float x; } a, b;") == Names{"a:1", "b:1"});
    CHECK(names_in("uniform Block { float x; } instance;") == Names{"Block:1"});
    CHECK(names_in("uniform float[3] a = float[3](1.0, 2.0, 3.0);") == Names{"a:1"});
    CHECK(names_in("// uniform float a;\n/* uniform float b; */\nfloat c;").empty());
    CHECK(names_in("#define U uniform float a;\nuniform float b;") == Names{"b:2"});
    CHECK(names_in("uniform float a").empty());
    CHECK(names_in("uniform").empty());
}

TEST_CASE("a comment belongs to all declarations of its line, up to the previous comment") {
    const auto found = find_declarations(
        "uniform float a, b;  // one\n"
        "uniform float c; /* two */ uniform float d; // three\n"
        "uniform float e,  // four\n"
        "              f;  // five\n"
        "uniform float g\n"
        "    = 1.0;  // six\n");
    REQUIRE(found.size() == 7);
    const Names expected{" one", " one", " two ", " three", " four", " five", " six"};
    for (std::size_t i = 0; i < found.size(); ++i) {
        REQUIRE(found[i].comments.size() == 1);
        CHECK(found[i].comments[0].text == expected[i]);
    }
}

namespace {
void check_error(const std::string& uniform, const std::string& message) {
    CHECK(error_of("\nuniform " + uniform) == "a.frag:3: error: " + message + "\n");
}
}  // namespace

TEST_CASE("every error in a range, a condition or a text is reported on its own line") {
    check_error("float a; // @rnage 0 1", "unknown annotation '@rnage' (did you mean '@range'?)");
    check_error("float a; // @", "unknown annotation '@'");
    check_error("float a; // @range 0 1 @range 0 1", "@range is used twice");
    check_error("float a; // @range 0", "@range takes a minimum, a maximum and an optional step");
    check_error("float a; // @range 0 x", "@range: expected a number, got 'x'");
    check_error("float a; // @range 0 1e39", "@range: 1e39 is not a valid float");
    check_error("float a; // @range 0 nan", "@range: expected a number, got 'nan'");
    check_error("float a; // @range 4 1",
                "@range: the minimum must be below the maximum, got 4 and 1");
    check_error("float a; // @range 1 1",
                "@range: the minimum must be below the maximum, got 1 and 1");
    check_error("float a; // @range 0 1 -1", "@range: the step must be above 0, got -1");
    check_error("int a; // @range 0 1.5", "@range: 1.5 is not a valid int");
    check_error("int a; // @range 0 2147483648", "@range: 2147483648 is not a valid int");
    check_error("uint a; // @limit -1 5", "@limit: -1 is not a valid uint");
    check_error("bool a; // @range 0 1", "@range is only for numbers; 'a' is a bool");
    check_error("float a = 2.0; // @limit 0 1", "the default 2 is outside @limit");
    check_error("float a; // @limit 0 1 @range 0 2", "@range must lie within @limit");
    check_error("float a; // @scale log @range 0 1",
                "@scale log needs a @range with a minimum above 0");
    check_error("float a; // @scale log", "@scale log needs a @range with a minimum above 0");
    check_error("float a; // @scale cubic", "@scale must be 'linear', 'log' or 'half-life'");
    check_error("float a; // @scale half-life @range 0 2",
                "@scale half-life needs a single float with a @range within 0 and 1");
    check_error("int a; // @scale half-life",
                "@scale half-life needs a single float with a @range within 0 and 1");
    check_error("float a; // @when", "@when takes an expression, such as @when mode == 1");
    check_error("float a; // @when a == \"x", "a string in this expression has no closing '\"'");
    check_error("float a; // @when gain > 0", "@when of 'a': no parameter 'gain'");
    check_error("float a; // @random yes", "@random must be 'no'");
    check_error("float a; // @label", "@label takes one text in quotes: @label \"...\"");
    check_error("float a; // @label Beam strength",
                "@label takes one text in quotes: @label \"...\"");
    check_error("float a; // @label \"Beam", "the string that starts here has no closing '\"'");
}

TEST_CASE("every error in a list, a control or a name is reported on its own line") {
    check_error("int a; // @items \"one\"",
                "@items takes at least two labels, for the values 0, 1, ...");
    check_error("int a = 2; // @items \"one\" \"two\"",
                "@items: the default must be a whole number from 0 to 1, got 2");
    check_error("bool a; // @items A B C", "@items of a bool takes two labels, for false and true");
    check_error("int a; // @items A B @items_was X Y Z",
                "@items_was takes up to 2 texts, one per item; use \"\" for an item without one");
    check_error("int a; // @items A B @items_note X Y Z",
                "@items_note takes up to 2 texts, one per item; use \"\" for an item without one");
    check_error("int a; // @items_color \"#ffffff\"",
                "@items_color needs @items in the same order");
    check_error("int a; // @items A B @items_color red",
                "@items_color: expected \"#rrggbb\" or \"\", got \"red\"");
    check_error("int a; // @items A B @items_was B", "@items_was: 'B' is also in @items");
    check_error("int a; // @items A B @items_was X X", "@items_was lists 'X' twice");
    check_error("int a; // @items_was X", "@items_was needs @items in the same order");
    check_error("vec2 a; // @items A B", "@items is only for single values; 'a' is a vec2");
    check_error("float a; // @color", "@color is only for vec3 and vec4; 'a' is a float");
    check_error("vec3 a; // @color red", "@color takes no arguments");
    check_error("ivec2 a; // @point", "@point is only for vec2; 'a' is an ivec2");
    check_error("vec2 a; // @angle", "@angle is only for float; 'a' is a vec2");
    check_error("vec3 a; // @identity 1 2", "@identity takes one number or 3");
    check_error("float a; // @photo off", "@photo off needs @identity");
    check_error("float a; // @photo start",
                "@photo start takes one number, such as @photo start 0");
    check_error("float a; // @photo none",
                "@photo must be shape, pitch, lines, type, amount, off, tube, decay or start");
    check_error("float a; // @was", "@was takes one name, the previous name of the parameter");
    check_error("float a; // @was a", "@was must be a previous name, not the current one");
    check_error("float a; // @hidden yes", "@hidden takes no arguments");
    check_error("float a; // @angle @items A B", "@items can't be combined with @angle");
    check_error("float a; // @parts A", "@parts is only for vectors; 'a' is a float");
    check_error("mat2 a; // @parts A B", "@parts is only for vectors; 'a' is a mat2");
    check_error("ivec2 a; // @parts A", "@parts of an ivec2 takes 2 labels");
    check_error("vec3 a; // @color @parts A B C", "@parts can't be combined with @color");
    check_error("sampler2D a; // @range 0 1", "@range is only for numbers; 'a' is a sampler");
}

TEST_CASE("an error in a continuation line is reported on that line") {
    CHECK(error_of("uniform float a;  // @range 0 1\n// @label \"x\"\n// @unt px") ==
          "a.frag:4: error: unknown annotation '@unt' (did you mean '@unit'?)\n");
}

TEST_CASE("a uniform without annotations gets a range from its type, name and default") {
    const auto range = [](const std::string& uniform) {
        return parameter_of("uniform " + uniform).range;
    };
    CHECK(range("bool a;") == Range{0.0, 1.0, 1.0});
    CHECK(range("float a;") == Range{0.0, 1.0, 0.0});
    CHECK(range("float vignette = 0.4;") == Range{0.0, 1.0, 0.0});
    CHECK(range("float gain = 0.5;") == Range{0.0, 2.0, 0.0});
    CHECK(range("float a = 28.0;") == Range{0.0, 112.0, 0.0});
    CHECK(range("float a = -0.5;") == Range{-1.0, 1.0, 0.0});
    CHECK(range("float a = -3.0;") == Range{-12.0, 12.0, 0.0});
    CHECK(range("vec2 shadow_offset;") == Range{-1.0, 1.0, 0.0});
    CHECK(range("int a = 13;") == Range{0.0, 52.0, 1.0});
    CHECK(range("int taps = 13;") == Range{1.0, 52.0, 1.0});
    CHECK(range("int a = -3;") == Range{-12.0, 12.0, 1.0});
    CHECK(range("uint a;") == Range{0.0, 10.0, 1.0});
    CHECK(range("mat2 a = mat2(1.0);") == Range{-1.0, 1.0, 0.0});
    CHECK(range("float rotation = 90.0;") == Range{-180.0, 180.0, 0.0});
    CHECK(range("float a = 3e38;").high == doctest::Approx(3.4028234663852886e38));
    CHECK(range("float a = 1.0; // @limit 0.5 0.9e9").low == 0.5);
}

TEST_CASE("a name determines whether a uniform is a colour, point or angle") {
    const auto control = [](const std::string& uniform) {
        return parameter_of("uniform " + uniform).control;
    };
    CHECK(control("vec3 beamColor = vec3(1.0);") == Control::color);
    CHECK(control("vec4 glass_tint;") == Control::color);
    CHECK(control("vec2 tint;") == Control::slider);
    CHECK(control("vec2 center = vec2(0.5);") == Control::point);
    CHECK(control("float mask_angle = 0.5;") == Control::angle);
    CHECK(control("float mask_angle = 0.5; // @range 0 360") == Control::slider);
    CHECK(parameter_of("uniform vec3 tint = vec3(4.0, 1.0, 1.0);").range == Range{0.0, 4.0, 0.0});
    CHECK(parameter_of("uniform float beam_width = 2.0;").label == "Beam width");
}
