#include "formats/shadertoy_export/shadertoy_document.h"

#include "formats/shadertoy/shadertoy_json.h"

#include <doctest/doctest.h>

TEST_CASE("a file is read again with its texts, buffers and samplers") {
    ShadertoyDocument document{.name = "A \"name\" */",
                               .author = "An\\author",
                               .about = "two\nlines",
                               .common = "// shared \"text\"\n",
                               .is_upright = false,
                               .passes = {}};
    Sampler rough;
    rough.filter = Filter::nearest;
    Sampler repeated;
    repeated.mipmap = true;
    repeated.wrap = Wrap::repeat;
    document.passes = {{-1, "image\t\x01", {{1, rough}, {-1, repeated}}}, {1, "buffer", {}}};
    Diagnostics warnings;
    const auto read = parse_shadertoy_json(shadertoy_json(document), "a.json", warnings);
    REQUIRE(read.has_value());
    CHECK(warnings.empty());
    CHECK(read->name == document.name);
    CHECK(read->author == document.author);
    CHECK(read->about == document.about);
    REQUIRE(read->passes.size() == 3);
    const ShadertoyPass& image = read->passes[0];
    CHECK(image.kind == ShadertoyPass::Kind::image);
    CHECK(*image.code.text == "image\t\x01");
    REQUIRE(image.inputs.size() == 2);
    CHECK(image.inputs[0].buffer == 1);
    CHECK(image.inputs[0].sampler == rough);
    CHECK(image.inputs[0].is_flipped);
    CHECK(image.inputs[1].channel == 1);
    CHECK(image.inputs[1].kind == ShadertoyKind::webcam);
    CHECK(image.inputs[1].sampler == repeated);
    CHECK_FALSE(image.inputs[1].is_flipped);
    CHECK(read->passes[1].name == "Buffer B");
    CHECK(*read->passes[2].code.text == document.common);
}
