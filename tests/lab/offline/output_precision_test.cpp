#include "lab/offline/output_precision.h"

#include <doctest/doctest.h>

namespace {
Parameter dither_of(const std::string& name, int pass) {
    Parameter parameter;
    parameter.name = name;
    parameter.initial = Value(1.0);
    parameter.identity = Value(0.0);
    parameter.bindings = {{pass, "dither"}};
    return parameter;
}

/// A stack of two looks that dither to 8 bits.
Look dithering_stack() {
    Look look;
    look.passes.resize(2);
    look.passes[0].name = "a/show";
    look.passes[1].name = "b/show";
    for (Pass& pass : look.passes)
        pass.format = Format::rgba8;
    look.parameters = {dither_of("a/dither", 0), dither_of("b/dither", 1)};
    return look;
}
}  // namespace

TEST_CASE("only the last pass gets more bits and loses its dithering") {
    Document document(dithering_stack());
    raise_precision(document);
    const Look drawn = document.drawn_look();
    CHECK(drawn.passes[0].format == Format::rgba8);
    CHECK(drawn.passes[1].format == Format::rgba32f);
    CHECK(document.value(drawn.parameters[0]) == Value(1.0));
    CHECK(document.value(drawn.parameters[1]) == Value(0.0));
    const Document original(dithering_stack());
    CHECK(with_precision_of(document, original).state() == original.state());
}

TEST_CASE("a format that the user chose stays, and dithering with it if it has few bits") {
    Document document(dithering_stack());
    document.amend([](DocumentState& state) { state.overrides["b/show"].format = Format::rgba8; });
    const DocumentState before = document.state();
    raise_precision(document);
    CHECK(document.state() == before);
    document.amend(
        [](DocumentState& state) { state.overrides["b/show"].format = Format::rgba16f; });
    raise_precision(document);
    CHECK(document.drawn_look().passes[1].format == Format::rgba16f);
    CHECK(document.value(document.look().parameters[1]) == Value(0.0));
}
