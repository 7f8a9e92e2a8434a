#include "formats/stack/stacked_look.h"

#include "model/plan/plan.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
// Reads a picture, its own previous frame and an image; one of its sizes depends on a parameter.
Look picture_look(const std::string& id, Encoding reads, Encoding writes) {
    Look look;
    look.id = id;
    look.name = "Look " + id;
    look.license = "MIT";
    look.driven_by = Driver::picture;
    look.default_source = "pattern:white";
    look.source_encoding = reads;
    look.output = writes;
    look.settle_frames = 5;
    look.images = {{"lut", "lut.png", {}}};
    Pass small;
    small.name = "small";
    small.size = {Side{Side::By::source, 0.5, {}},
                  Side{Side::By::expression, 1, "$HEIGHT / $cells"}};
    small.inputs = {{"image", Input::From::source, "", 0, {}},
                    {"before", Input::From::source, "", 2, {}},
                    {"colors", Input::From::image, "lut", 0, {}}};
    Pass show;
    show.name = "show";
    show.format = Format::rgba8;
    show.inputs = {{"image", Input::From::pass, "small", 0, {}},
                   {"trail", Input::From::pass, "show", 1, {}}};
    look.passes = {small, show};
    Parameter cells;
    cells.name = "cells";
    cells.initial = 4.0;
    cells.group = "Grid";
    cells.was = "rows";
    cells.bindings = {{0, "cells"}};
    look.parameters = {cells};
    return look;
}

Look signal_look(const std::string& id) {
    Look look;
    look.id = look.name = id;
    look.driven_by = Driver::signal;
    look.default_signal = Spec{"lissajous", {}};
    look.settle_frames = 100;
    Pass beam;
    beam.name = "beam";
    look.passes = {beam};
    return look;
}

Look stacked(const std::vector<Look>& looks, const std::vector<std::string>& bypass = {}) {
    Stack stack;
    for (const Look& look : looks)
        stack.push_back({look.id, look.id, free_tag(stack, look.id)});
    Diagnostics warnings;
    Look made = stacked_look(looks, with_bypass(std::move(stack), bypass), warnings);
    CHECK(warnings.empty());
    return made;
}

constexpr Encoding linear = Encoding::linear;
constexpr Encoding display = Encoding::display;
}  // namespace

TEST_CASE("a stack reads its source in the format of its first active look") {
    Look coarse = picture_look("game", display, display);
    coarse.source_format = Format::rgba8;
    const Look fine = picture_look("crt", display, display);
    CHECK(stacked({coarse, fine}).source_format == Format::rgba8);
    CHECK(stacked({fine, coarse}).source_format == Format::rgba32f);
    CHECK(stacked({coarse, fine}, {"game"}).source_format == Format::rgba32f);
}

TEST_CASE("passes, images and parameters of a stack are prefixed with the key of their look") {
    const Look look =
        stacked({picture_look("crt", display, display), picture_look("crt", display, display)});
    CHECK(pass_names(look) ==
          std::vector<std::string>{"crt/small", "crt/show", "crt#2/small", "crt#2/show"});
    CHECK(parameter_names(look) == std::vector<std::string>{"crt/cells", "crt#2/cells"});
    CHECK(look.parameters[1].bindings == std::vector<Binding>{{2, "cells"}});
    CHECK(look.parameters[1].was == "crt#2/rows");
    CHECK(look.parameters[0].group == "Look crt: Grid");
    CHECK(look.parameters[1].group == "Look crt 2: Grid");
    CHECK(look.passes[2].rename.at("cells") == "crt#2/cells");
    CHECK(look.passes[2].inputs[2].name == "crt#2/lut");
    CHECK(look.passes[3].inputs[0].name == "crt#2/small");
    CHECK(look.passes[3].inputs[1].reference() == "crt#2/show@1");
    CHECK(look.id == "crt+crt");
    CHECK(look.name == "Look crt + Look crt");
    CHECK(look.license == "MIT");
    CHECK(look.settle_frames == 9);  // four more frames after the first look has settled in five
    CHECK(look.driven_by == Driver::picture);
    CHECK(look.default_source == "pattern:white");
}

TEST_CASE("the last pass of a look is the source of the next one, in earlier frames too") {
    const Look look = stacked({signal_look("scope"), picture_look("crt", display, linear)});
    CHECK(look.passes[1].inputs[0].reference() == "scope/beam");
    CHECK(look.passes[1].inputs[1].reference() == "scope/beam@2");
    CHECK(look.driven_by == Driver::signal);
    CHECK(look.default_signal == Spec{"lissajous", {}});
    CHECK(look.output == linear);
    CHECK(encoding_of(look, 0) == display);
    CHECK(look.settle_frames == 104);
}

TEST_CASE("a picture goes through the looks before sub-frames once per source frame") {
    const auto once = [](const Look& look) {
        std::vector<bool> passes;
        for (const Pass& pass : look.passes)
            passes.push_back(pass.per_source_frame);
        return passes;
    };
    Look scan = picture_look("scan", linear, display);
    scan.subframes = std::string("cells");
    const Look crt = picture_look("crt", display, display);
    const Look look = stacked({crt, scan, crt});  // with a conversion before the scan
    CHECK(look.subframes == Count("scan/cells"));
    CHECK(once(look) == std::vector<bool>{true, true, true, false, false, false, false});
    const Look beam = stacked({signal_look("scope"), scan});
    CHECK(beam.subframes == Count("scan/cells"));
    CHECK(std::ranges::count(once(beam), true) == 0);
    CHECK(stacked({crt, scan}, {"scan"}).subframes == Count(1));
}

TEST_CASE("encodings are converted between two looks only if they differ") {
    const auto conversions = [](Encoding writes, Encoding reads) {
        Look first = picture_look("a", linear, writes);
        return pass_names(stacked({first, picture_look("b", reads, display)})).size() - 4;
    };
    CHECK(conversions(display, display) == 0);
    CHECK(conversions(linear, linear) == 0);
    CHECK(conversions(display, linear) == 1);
    CHECK(conversions(linear, display) == 1);

    Look first = picture_look("a", linear, display);
    const Look look = stacked({first, picture_look("b", linear, display)});
    CHECK(look.passes[2].name == "b/source");
    CHECK(look.passes[2].format == Format::rgba16f);
    CHECK(look.passes[2].inputs[0].reference() == "a/show");
    CHECK(look.passes[3].inputs[0].reference() == "b/source");
    CHECK(look.passes[3].inputs[1].reference() == "b/source@2");
    CHECK(encoding_of(look, 1) == display);
    CHECK(encoding_of(look, 2) == linear);
    // Images are decoded as each look reads its source.
    CHECK(look.images[1].encoding == linear);
    first.passes[1].format = Format::rgba32f;
    CHECK(stacked({first, picture_look("b", linear, display)}).passes[2].format == Format::rgba32f);
}

TEST_CASE("sizes in a stack depend on the previous look and on the look's own parameters") {
    Look first = picture_look("a", display, display);
    first.passes[1].size = {Side{Side::By::pixels, 60, {}}, Side{Side::By::pixels, 30, {}}};
    const Look look = stacked({first, picture_look("b", display, display)});
    const Plan plan = plan_targets(look, {640, 480}, {320, 200}, {{"b/cells", 8.0}}).value();
    CHECK(plan.targets[0].extent == Extent{160, 120});  // half the source, 480 / 4
    CHECK(plan.targets[2].extent == Extent{30, 60});    // half the previous look, 480 / 8
    CHECK(plan.targets[1].slots == 3);                  // "source@2" of the second look
    CHECK(redraw_after(look, {"b/cells"}).passes == std::vector<bool>{false, false, true, true});
}

TEST_CASE("a bypassed look keeps its parameters and is not drawn") {
    const std::vector<Look> looks{picture_look("a", linear, display),
                                  picture_look("b", linear, display)};
    const Look second = stacked(looks, {"a"});
    CHECK(pass_names(second) == std::vector<std::string>{"b/small", "b/show"});
    CHECK(second.passes[0].inputs[0].reference() == "source");
    CHECK(parameter_names(second) == std::vector<std::string>{"a/cells", "b/cells"});
    CHECK(second.parameters[0].bindings.empty());
    CHECK(second.parameters[1].bindings == std::vector<Binding>{{0, "cells"}});
    CHECK(look_digest(second) == look_digest(stacked(looks)));

    const Look none = stacked(looks, {"a", "b"});
    REQUIRE(none.passes.size() == 1);
    CHECK(none.passes[0].inputs[0].reference() == "source");
    CHECK(none.output == none.source_encoding);

    const Look without_scope =
        stacked({signal_look("scope"), picture_look("crt", linear, display)}, {"scope"});
    CHECK(without_scope.driven_by == Driver::picture);
    CHECK(without_scope.default_source == "pattern:white");
}

TEST_CASE("looks before one without a picture input are not drawn, with a warning") {
    const std::vector<Look> looks{picture_look("crt", linear, display), signal_look("scope")};
    Diagnostics warnings;
    const Look look = stacked_look(looks, {{"crt", "", "crt"}, {"scope", "", "scope"}}, warnings);
    CHECK(pass_names(look) == std::vector<std::string>{"scope/beam"});
    CHECK(look.driven_by == Driver::signal);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].message ==
          "'crt' isn't drawn because the later look 'scope' doesn't use a picture");
}

TEST_CASE("in a stack a pass is drawn onto a pass of its own look") {
    Look scope = signal_look("scope");
    scope.passes[0].onto = Onto{"glow", "1"};
    Pass glow;
    glow.name = "glow";
    scope.passes.push_back(glow);
    const Look look = stacked({scope, picture_look("crt", Encoding::linear, Encoding::linear)});
    CHECK(look.passes[0].onto == Onto{"scope/glow", "1"});
}
