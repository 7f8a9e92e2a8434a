#include "lab/menus/preset_difference.h"

#include "lab/document/opened_preset.h"
#include "lab/document/stack_edits.h"

#include <doctest/doctest.h>

namespace {
Parameter preset_parameter(const std::string& name, double initial) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = label_from_name(name);
    parameter.initial = Value(initial);
    parameter.limit = Limit{0.0, 10.0};
    return parameter;
}

Document open_document() {
    Look look;
    look.id = "small";
    look.driven_by = Driver::signal;
    look.default_signal = Spec{"lissajous", {{"x", 3.0}}};
    look.parameters = {preset_parameter("decay", 0.92), preset_parameter("exposure", 1.5),
                       preset_parameter("gain", 1.0)};
    look.parameters[2].was = "amplitude";
    return Document(look);
}
}  // namespace

TEST_CASE("a preset is compared with the open values, and missing values are the defaults") {
    Document document = open_document();
    document.set_value("exposure", Value(4.0));
    Preset preset;
    preset.look = "small";
    preset.values = {{"decay", Value(0.61)}, {"amplitude", Value(1.0)}};
    preset.signal = Spec{"lissajous", {{"x", 5.0}}};
    CHECK(difference_from(preset, document) ==
          std::vector<Change>{{"decay", "Decay", "0.61", "0.92", ""},
                              {"exposure", "Exposure", "1.5", "4", ""},
                              {{}, "Signal: X frequency", "5", "3", "per 1/60 s"}});
    CHECK(document.history().undo_name() == "Exposure");  // the document is unchanged
}

TEST_CASE("a preset does not differ from itself or by values that it cannot store") {
    Document document = open_document();
    document.set_value("decay", Value(0.5));
    set_override(document, "beam", {.format = {}, .scale = 0.5, .filter = {}});
    CHECK(difference_from(preset_of(document), document).empty());
    CHECK(difference_from(complete_preset_of(document), document).empty());
    Preset beyond = preset_of(document);
    beyond.values["decay"] = Value(99.0);  // is clamped to the hard limit on opening
    document.set_value("decay", Value(10.0));
    CHECK(difference_from(beyond, document).empty());
}
