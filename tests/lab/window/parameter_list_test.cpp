#include "lab/window/parameter_list.h"

#include "lab/document/parameter_edits.h"

#include <doctest/doctest.h>

namespace {
Parameter listed_parameter(const std::string& name, const std::string& group, int pass) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = label_from_name(name);
    parameter.group = group;
    parameter.initial = Value(0.0);
    parameter.bindings = {{pass, name}};
    return parameter;
}

Look look() {
    Look made;
    made.passes.resize(2);
    made.passes[0].name = "beam";
    made.passes[1].name = "screen";
    made.parameters = {listed_parameter("focus", "Beam", 0), listed_parameter("glow", "", 1),
                       listed_parameter("gain", "Beam", 0), listed_parameter("tint", "", 1)};
    made.parameters[1].help = "Light that stays in the glass.";
    made.parameters.push_back(listed_parameter("secret", "Beam", 0));
    made.parameters.back().is_hidden = true;
    return made;
}

// Example: "Beam: focus gain; Screen: glow".
std::string text(const Document& document, const ParameterQuery& query) {
    std::string all;
    for (const ParameterGroup& group : listed_parameters(document, query)) {
        all += (all.empty() ? "" : "; ") + group.name + ':';
        for (const Parameter* parameter : group.parameters)
            all += ' ' + parameter->name;
    }
    return all;
}
}  // namespace

TEST_CASE("parameters are listed under their groups, or under their passes") {
    CHECK(text(Document(look()), {}) == "Beam: focus gain; Screen: glow tint");
}

TEST_CASE("a search finds every word in the name, heading or help") {
    const Document document(look());
    CHECK(text(document, {.search = "GLASS light"}) == "Screen: glow");
    CHECK(text(document, {.search = "beam ga"}) == "Beam: gain");
    CHECK(text(document, {.search = "glass beam"}).empty());
}

TEST_CASE("the list is filtered to changed, favourite or used parameters") {
    Document document(look());
    CHECK(text(document, {.filter = ParameterFilter::changed}).empty());
    document.set_value("glow", Value(0.5));
    set_parameter_setting(document, "gain", {.is_favourite = true});
    CHECK(text(document, {.filter = ParameterFilter::changed}) == "Screen: glow");
    CHECK(text(document, {.filter = ParameterFilter::favourites}) == "Beam: gain");
    const ParameterQuery of_screen{.filter = ParameterFilter::of_pass, .pass = "screen"};
    CHECK(text(document, of_screen) == "Screen: glow tint");
    CHECK(text(document, {.search = "tin", .filter = of_screen.filter, .pass = "screen"}) ==
          "Screen: tint");
    CHECK(text(document, {.filter = ParameterFilter::of_pass, .pass = "gone"}).empty());
}

TEST_CASE("an empty list shows the reason") {
    CHECK(empty_list_text({.search = "x"}) == "No matches.");
    CHECK(empty_list_text({.filter = ParameterFilter::changed}) == "No parameters are changed.");
    CHECK(empty_list_text({.filter = ParameterFilter::of_pass, .pass = "beam"}) ==
          "The pass \"beam\" uses no parameters.");
}

TEST_CASE("keys move through the list, including components, and stop at its ends") {
    Look made = look();
    made.parameters[2].type = {Scalar::floating, 2};  // gain
    const Document document(made);
    const auto groups = listed_parameters(document, {});
    std::string way;
    Pointed at{};
    for (int i = 0; i < 6; ++i) {
        at = *listed_neighbour(groups, at, 1);
        way += at.parameter + char('0' + at.component) + ' ';
    }
    CHECK(way == "focus0 gain0 gain1 glow0 tint0 tint0 ");
    CHECK(listed_neighbour(groups, {"glow", 0}, -1) == Pointed{"gain", 1});
    CHECK(listed_neighbour(groups, {"focus", 0}, -1) == Pointed{"focus", 0});
    CHECK(listed_neighbour(groups, {"gone", 0}, -1) == Pointed{"tint", 0});
    CHECK(listed_neighbour({}, {"glow", 0}, 1) == std::nullopt);
}
