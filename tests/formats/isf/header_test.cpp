#include "formats/isf/header.h"

#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
using Type = IsfInput::Type;

IsfHeader header_of(const std::string& json) {
    auto header = read_isf_header("/*" + json + "*/\nvoid main() {}\n", "a.fs");
    REQUIRE_MESSAGE(header.has_value(), problems_of(header));
    return std::move(*header);
}

std::string refusal_of(const std::string& text) {
    const auto header = read_isf_header(text, "a.fs");
    REQUIRE_FALSE(header.has_value());
    return to_string(header.error());
}
}  // namespace

TEST_CASE("an ISF shader's first block comment contains a JSON object") {
    CHECK(has_isf_header("/*{}*/ void main() {}"));
    CHECK(has_isf_header("\n// by me\n/*\n  { \"A\": 1 }\n*/"));
    CHECK(has_isf_header("#version 150\n# extension GL_ARB_x : enable\n/*{}*/ void main() {}"));
    CHECK(has_isf_header("#define A\n/*{}*/ void main() {}"));
    CHECK(has_isf_header("// /*{ a line\nvoid main() {} /*{}*/"));
    CHECK_FALSE(has_isf_header("/* a comment */ void main() {}"));
    CHECK_FALSE(has_isf_header("/* a comment */ /*{}*/ void main() {}"));
    CHECK_FALSE(has_isf_header("// only a line"));
    CHECK_FALSE(has_isf_header("/*{ that never ends"));
    CHECK_FALSE(has_isf_header(""));
}

TEST_CASE("the code of an ISF shader starts after its header, on a known line") {
    const std::string text = "\n/*{\n\"DESCRIPTION\": \"d\"\n}*/ void main() {}\n";
    const auto header = read_isf_header(text, "a.fs");
    REQUIRE(header.has_value());
    CHECK(header->about == "d");
    CHECK(text.substr(header->code_begin) == " void main() {}\n");
    CHECK(header->code_line == 4);
}

TEST_CASE("inputs are read with type, range, default and labels") {
    const IsfHeader header = header_of(R"({"INPUTS": [
        {"NAME": "a", "TYPE": "float", "MIN": -1, "MAX": 3.5, "DEFAULT": 2, "IDENTITY": 0},
        {"NAME": "b", "TYPE": "bool", "DEFAULT": true, "LABEL": "Switch"},
        {"NAME": "c", "TYPE": "long", "VALUES": [1, 5], "LABELS": ["one", "five"]},
        {"NAME": "d", "TYPE": "event"}, {"NAME": "e", "TYPE": "point2D", "DEFAULT": [0.5, 1]},
        {"NAME": "f", "TYPE": "color"}, {"NAME": "g", "TYPE": "image"},
        {"NAME": "h", "TYPE": "audio", "MAX": 64}, {"NAME": "i", "TYPE": "audioFFT"}]})");
    const std::vector<Type> types{Type::floating, Type::boolean, Type::integer,
                                  Type::event,    Type::point,   Type::color,
                                  Type::image,    Type::audio,   Type::audio_fft};
    REQUIRE(header.inputs.size() == types.size());
    for (std::size_t i = 0; i < types.size(); ++i)
        CHECK(header.inputs[i].type == types[i]);
    CHECK(header.inputs[0].low == std::vector{-1.0});
    CHECK(header.inputs[0].high == std::vector{3.5});
    CHECK(header.inputs[0].identity == std::vector{0.0});
    CHECK(header.inputs[1].initial == std::vector{1.0});
    CHECK(header.inputs[1].label == "Switch");
    CHECK(header.inputs[2].labels == std::vector<std::string>{"one", "five"});
    CHECK(header.inputs[4].initial == std::vector{0.5, 1.0});
    CHECK(header.inputs[7].high == std::vector{64.0});
    CHECK(header.inputs[0].declared == Location{"a.fs", 2});
}

TEST_CASE("numbers and booleans may be written as strings") {
    const IsfHeader header = header_of(R"({"INPUTS": [
        {"NAME": "a", "TYPE": "bool", "DEFAULT": "false"},
        {"NAME": "b", "TYPE": "bool", "DEFAULT": "TRUE"},
        {"NAME": "c", "TYPE": "float", "DEFAULT": "0.25", "MIN": "0", "MAX": "4"},
        {"NAME": "d", "TYPE": "point2D", "DEFAULT": ["1", "2.5"]},
        {"NAME": "e", "TYPE": "bool", "DEFAULT": "perhaps"}]})");
    CHECK(header.inputs[0].initial == std::vector{0.0});
    CHECK(header.inputs[1].initial == std::vector{1.0});
    CHECK(header.inputs[2].initial == std::vector{0.25});
    CHECK(header.inputs[2].low == std::vector{0.0});
    CHECK(header.inputs[2].high == std::vector{4.0});
    CHECK(header.inputs[3].initial == std::vector{1.0, 2.5});
    CHECK(header.inputs[4].initial.empty());
}

TEST_CASE("a pass is persistent by true, a number or a string") {
    const IsfHeader header = header_of(R"({"PASSES": [
        {"TARGET": "a", "PERSISTENT": true, "FLOAT": true}, {"TARGET": "b", "PERSISTENT": 1},
        {"TARGET": "c", "PERSISTENT": "true", "FLOAT": "YES"}, {"TARGET": "d", "persistent": true},
        {"TARGET": "e", "PERSISTENT": "false"}, {"PERSISTENT": 0, "WIDTH": 64,
         "HEIGHT": "$HEIGHT/2", "SPEED": "unknown"}]})");
    std::vector<bool> persistent;
    for (const IsfPass& pass : header.passes)
        persistent.push_back(pass.is_persistent);
    CHECK(persistent == std::vector{true, true, true, false, false, false});
    CHECK(header.passes[0].is_float);
    CHECK_FALSE(header.passes[1].is_float);
    CHECK(header.passes[2].is_float);
    CHECK(header.passes[5].width == "64");
    CHECK(header.passes[5].height == "$HEIGHT/2");
}

TEST_CASE("the last of duplicate keys counts, and unknown keys are ignored") {
    const IsfHeader header =
        header_of(R"({"DESCRIPTION": "a", "KEYWORDS": {"x": [1]}, "DESCRIPTION": "b"})");
    CHECK(header.about == "b");
}

TEST_CASE("a header without passes has one pass") {
    CHECK(header_of("{}").passes.size() == 1);
    CHECK(header_of(R"({"PASSES": []})").passes.size() == 1);
}

TEST_CASE("persistent buffers of ISF version 1 are merged into their passes") {
    const IsfHeader named =
        header_of(R"({"PERSISTENT_BUFFERS": ["b"], "PASSES": [{"TARGET": "a"}, {"TARGET": "b"}]})");
    CHECK_FALSE(named.passes[0].is_persistent);
    CHECK(named.passes[1].is_persistent);
    const IsfHeader sized = header_of(
        R"({"PERSISTENT_BUFFERS": {"a": {"WIDTH": 8, "HEIGHT": "$WIDTH", "FLOAT": true}},
            "PASSES": [{"TARGET": "a", "HEIGHT": "4"}]})");
    CHECK(sized.passes[0].is_persistent);
    CHECK(sized.passes[0].is_float);
    CHECK(sized.passes[0].width == "8");
    CHECK(sized.passes[0].height == "4");
}

TEST_CASE("imports are an object or a list") {
    const IsfHeader object = header_of(R"({"IMPORTED": {"mask": {"PATH": "a/mask.png"}}})");
    const IsfHeader list = header_of(R"({"IMPORTED": [{"NAME": "mask", "PATH": "a/mask.png"}]})");
    for (const IsfHeader& header : {object, list}) {
        REQUIRE(header.imports.size() == 1);
        CHECK(header.imports[0].name == "mask");
        CHECK(header.imports[0].path == "a/mask.png");
        CHECK_FALSE(header.imports[0].is_cube);
    }
}

TEST_CASE("an import of six pictures is a cube map, and other numbers are errors") {
    const IsfHeader six = header_of(
        R"({"IMPORTED": [{"NAME": "a", "TYPE": "cube", "PATH": ["0", "1", "2", "3", "4", "5"]}]})");
    CHECK(six.imports[0].is_cube);
    CHECK(six.imports[0].faces == std::vector<std::string>{"0", "1", "2", "3", "4", "5"});
    const IsfHeader one = header_of(R"({"IMPORTED": {"a": {"TYPE": "cube", "PATH": "sky.png"}}})");
    CHECK(one.imports[0].is_cube);
    CHECK(one.imports[0].faces.empty());
    CHECK(refusal_of(
              "/*{\n\"IMPORTED\": [{\"NAME\": \"a\", \"TYPE\": \"cube\", \"PATH\": [\"0\"]}]}*/") ==
          "a.fs:2: error: 'PATH' of 'a' lists 1 pictures; use 1, or 6 for a cube map\n");
}

TEST_CASE("a colour may be written as hexadecimal text") {
    const auto color = [](const std::string& text) {
        return header_of(R"({"INPUTS": [{"NAME": "c", "TYPE": "color", "DEFAULT": ")" + text +
                         "\"}]}")
            .inputs[0]
            .initial;
    };
    CHECK(color("#ff8000") == std::vector<double>{1.0, 128 / 255.0, 0.0});
    CHECK(color("#0f08") == std::vector<double>{0.0, 1.0, 0.0, 136 / 255.0});
    CHECK(refusal_of("/*{\n\"INPUTS\": [{\"NAME\": \"c\", \"TYPE\": \"color\", \"DEFAULT\": "
                     "\"#ggg\"}]}*/")
              .starts_with("a.fs:2: error: '#ggg' isn't a colour"));
}

TEST_CASE("the kind of an ISF shader follows from its inputs") {
    using Kind = IsfHeader::Kind;
    CHECK(header_of("{}").kind() == Kind::generator);
    CHECK(header_of(R"({"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}]})").kind() ==
          Kind::filter);
    CHECK(header_of(R"({"INPUTS": [{"NAME": "startImage", "TYPE": "image"},
        {"NAME": "endImage", "TYPE": "image"}, {"NAME": "progress", "TYPE": "float"}]})")
              .kind() == Kind::transition);
    CHECK(header_of(R"({"INPUTS": [{"NAME": "startImage", "TYPE": "image"},
        {"NAME": "endImage", "TYPE": "image"}]})")
              .kind() == Kind::generator);
}

TEST_CASE("errors in a header are reported at their lines") {
    CHECK(refusal_of("/*{\n\"A\": 1,\n\"B\" 2}*/").starts_with("a.fs:3: error: "));
    CHECK(refusal_of("void main() {}").starts_with("a.fs:1: error: not an ISF shader: "));
    CHECK(refusal_of("/*{\"INPUTS\": [\n{\"NAME\": \"a\", \"TYPE\": \"volume\"},\n"
                     "{\"NAME\": \"b c\", \"TYPE\": \"float\"},\n{\"TYPE\": \"float\"},\n"
                     "{\"NAME\": \"d\", \"TYPE\": \"float\"},\n"
                     "{\"NAME\": \"d\", \"TYPE\": \"bool\"}]}*/") ==
          "a.fs:2: error: input 'a' has unknown type 'volume'; use float, bool, long, event, "
          "point2D, color, image, cube, audio or audioFFT\n"
          "a.fs:3: error: 'b c' isn't a valid GLSL identifier\n"
          "a.fs:4: error: 'NAME' is missing\n"
          "a.fs:6: error: the name 'd' is used twice\n");
    CHECK(refusal_of("/*{\"INPUTS\": [{\"NAME\": \"TIME\", \"TYPE\": \"float\"}],\n"
                     "\"PASSES\": [{\"TARGET\": \"a b\"}]}*/") ==
          "a.fs:1: error: 'TIME' is a reserved name in ISF\n"
          "a.fs:2: error: 'a b' isn't a valid GLSL identifier\n");
    CHECK(refusal_of("/*{\"INPUTS\": {}}*/").find("'INPUTS' must be a list, got") !=
          std::string::npos);
}
