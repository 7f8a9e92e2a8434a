#include "lab/menus/scope_graticule.h"

#include <doctest/doctest.h>

namespace {
Parameter scope_parameter(const std::string& name, Value initial) {
    Parameter parameter;
    parameter.name = name;
    parameter.type.rows = static_cast<int>(initial.numbers.size());
    parameter.initial = std::move(initial);
    return parameter;
}

Look scope_look(const std::string& scope = {}) {
    Look look;
    look.passes.resize(1);
    look.passes.front().scope = scope;
    look.parameters = {
        scope_parameter(scope + "graticule", Value(0.15)),
        scope_parameter(scope + "graticule_divisions", Value(std::vector<double>{10, 10})),
        scope_parameter(scope + "fit", Value(0.0))};
    return look;
}

const Value ten_by_eight(std::vector<double>{10, 8});
}  // namespace

TEST_CASE("traces over time request a 10 by 8 graticule over the whole picture") {
    const Look look = scope_look();
    const Spec traces{"waveform", {}};
    const Values divisions{{"graticule_divisions", ten_by_eight}};
    CHECK(scope_graticule(look, {}, traces) == divisions);
    CHECK(scope_graticule(look, divisions, traces).empty());
    const Values square{{"graticule_divisions", ten_by_eight}, {"fit", Value(1.0)}};
    CHECK(scope_graticule(look, square, traces) == Values{{"fit", Value(0.0)}});
    CHECK(scope_graticule(look, {}, {"audio", {{"file", "a.wav"}, {"mode", "waveform"}}}) ==
          divisions);
    const Look stacked = scope_look("phosphor/");
    CHECK(scope_graticule(stacked, {}, traces) ==
          Values{{"phosphor/graticule_divisions", ten_by_eight}});
}

TEST_CASE("signals without traces and looks without a graticule request nothing") {
    const Look look = scope_look();
    for (const Spec& signal :
         {Spec{"lissajous", {}}, Spec{"waveform", {{"mode", "xy"}}}, Spec{"harmonics", {}},
          Spec{"audio", {{"file", "a.wav"}, {"mode", "spectrum"}}}, Spec{}})
        CHECK(scope_graticule(look, {}, signal).empty());
    CHECK(scope_graticule(look, {{"graticule", Value(0.0)}}, {"waveform", {}}).empty());
    CHECK(scope_graticule(Look{}, {}, {"waveform", {}}).empty());
}
