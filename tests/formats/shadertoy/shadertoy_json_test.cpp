#include "formats/shadertoy/shadertoy_json.h"

#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
using Kind = ShadertoyPass::Kind;

Shadertoy shadertoy_in(const std::string& text) {
    Diagnostics warnings;
    auto shadertoy = parse_shadertoy_json(text, "a.json", warnings);
    REQUIRE_MESSAGE(shadertoy.has_value(), problems_of(shadertoy));
    CHECK(to_string(warnings) == "");
    return *shadertoy;
}

std::string warnings_of(const std::string& passes) {
    Diagnostics warnings;
    const auto shadertoy =
        parse_shadertoy_json("{\"renderpass\": [" + passes + "]}", "a.json", warnings);
    CHECK(shadertoy.has_value());
    return to_string(warnings);
}

constexpr const char* exported = R"([{"ver": "0.1",
  "info": {"id": "x", "name": "Waves", "username": "ann", "description": "Water"},
  "renderpass": [
    {"inputs": [{"id": "XsXGR8", "filepath": "/media/previz/buffer01.png", "type": "buffer",
                 "channel": 2, "sampler": {"filter": "mipmap", "wrap": "repeat", "vflip": "true"}},
                {"id": "Xdf", "filepath": "/media/a/1234.jpg", "type": "texture", "channel": 0,
                 "sampler": {"filter": "nearest", "wrap": "mirror", "vflip": "false"}}],
     "outputs": [{"id": "4dfGRr", "channel": 0}], "code": "one\ntwo", "name": "Image", "type": "image"},
    {"inputs": [], "outputs": [{"id": "XsXGR8", "channel": 0}], "code": "b", "name": "Buf @",
     "type": "buffer"},
    {"inputs": [], "outputs": [], "code": "c", "name": "", "type": "common"}]}])";

constexpr const char* answered = R"({"Shader": {"ver": "0.1",
  "info": {"name": "Waves", "username": "ann", "description": "Water"},
  "renderpass": [
    {"inputs": [{"id": 258, "src": "/media/previz/buffer01.png", "ctype": "buffer", "channel": 2,
                 "sampler": {"filter": "mipmap", "wrap": "repeat", "vflip": true}},
                {"id": 30, "src": "/media/a/1234.jpg", "ctype": "texture", "channel": 0,
                 "sampler": {"filter": "nearest", "wrap": "mirror", "vflip": false}}],
     "outputs": [{"id": 37, "channel": 0}], "code": "one\ntwo", "name": "Image", "type": "image"},
    {"inputs": [], "outputs": [{"id": 258, "channel": 0}], "code": "b", "name": "", "type": "buffer"},
    {"inputs": [], "outputs": [], "code": "c", "name": "Common", "type": "common"}]}})";
}  // namespace

TEST_CASE("both dialects of Shadertoy JSON are read the same") {
    for (const char* text : {exported, answered}) {
        CHECK(is_shadertoy_json(text));
        const Shadertoy shadertoy = shadertoy_in(text);
        CHECK(shadertoy.name == "Waves");
        CHECK(shadertoy.author == "ann");
        CHECK(shadertoy.about == "Water");
        REQUIRE(shadertoy.passes.size() == 3);
        const ShadertoyPass& image = shadertoy.passes[0];
        CHECK(image.kind == Kind::image);
        CHECK(image.code.text == "one\ntwo");
        CHECK(origin_of(image.code.lines, 2) == Location{"a.json/Image", 2});
        REQUIRE(image.inputs.size() == 2);
        CHECK(image.inputs[0].kind == ShadertoyKind::buffer);
        CHECK(image.inputs[0].channel == 2);
        CHECK(image.inputs[0].buffer == 1);
        CHECK(image.inputs[0].sampler == Sampler{Filter::linear, Wrap::repeat, true});
        CHECK(image.inputs[0].is_flipped);
        CHECK(image.inputs[1].sampler == Sampler{Filter::nearest, Wrap::mirror, false});
        CHECK_FALSE(image.inputs[1].is_flipped);
        CHECK(image.inputs[1].asset == "/media/a/1234.jpg");
        CHECK(shadertoy.passes[1].name == "Buffer B");
        CHECK(shadertoy.passes[1].index == 1);
        CHECK(shadertoy.passes[2].kind == Kind::common);
    }
}

TEST_CASE("a buffer is identified by its output id, and an unknown id gets a free buffer") {
    const Shadertoy shadertoy = shadertoy_in(R"({"renderpass": [
        {"outputs": [{"id": "mine"}], "code": "", "type": "buffer",
         "inputs": [{"id": "mine", "type": "buffer", "channel": 0}]},
        {"outputs": [{"id": "4dXGR8"}], "code": "", "type": "buffer", "name": "Buffer D"}]})");
    CHECK(shadertoy.passes[0].name == "Buffer B");
    CHECK(shadertoy.passes[0].inputs[0].buffer == 1);
    CHECK(shadertoy.passes[1].name == "Buffer A");
}

TEST_CASE("unsupported parts of a shader give warnings and are ignored") {
    CHECK(warnings_of(R"({"type": "dance", "code": ""})") ==
          "a.json:1: warning: unknown pass type 'dance'; the pass is ignored\n");
    CHECK(warnings_of(R"({"type": "image", "code": "", "inputs": [
{"type": "smell", "channel": 1}]})") ==
          "a.json:2: warning: iChannel1 of 'Image' has unknown type 'smell'; it is black\n");
    CHECK(warnings_of(R"({"type": "image", "code": "", "inputs": [
{"type": "texture", "channel": 4}]})") ==
          "a.json:2: warning: an input of 'Image' is ignored because its channel isn't a "
          "number from 0 to 3\n");
    CHECK(warnings_of(
              "{\"type\": \"image\", \"code\": \"\"},\n{\"type\": \"image\", \"code\": \"\"}") ==
          "a.json:2: warning: 'Image' already exists; this pass is ignored\n");
}

TEST_CASE("invalid JSON and passes without code are rejected with a line") {
    Diagnostics warnings;
    CHECK(to_string(parse_shadertoy_json("\n[]", "a.json", warnings).error()) ==
          "a.json:2: error: not a Shadertoy shader: the list 'renderpass' is missing\n");
    CHECK(to_string(
              parse_shadertoy_json("{\"renderpass\":\n[{\"type\": \"image\"}]}", "a.json", warnings)
                  .error()) == "a.json:2: error: pass 'Image' has no code\n");
    CHECK_FALSE(parse_shadertoy_json("{\"renderpass\": [", "a.json", warnings).has_value());
}

TEST_CASE("an error message of Shadertoy is shown") {
    const std::string answer = "{\n\"Error\": \"Shader not found\"}";
    CHECK(is_shadertoy_json(answer));
    CHECK_FALSE(is_shadertoy_json(R"({"format": 1, "Error": "x"})"));
    Diagnostics warnings;
    const auto shadertoy = parse_shadertoy_json(answer, "a.json", warnings);
    REQUIRE_FALSE(shadertoy.has_value());
    CHECK(to_string(shadertoy.error()) ==
          "a.json:2: error: Shadertoy sent an error instead of a shader: 'Shader not found'\n");
}
