#include "lab/document/document.h"

#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "lab/document/stack_edits.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
Parameter parameter_named(const std::string& name, double initial) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = label_from_name(name);
    parameter.initial = Value(initial);
    parameter.limit = Limit{0.0, 10.0};
    return parameter;
}

Look document_look() {
    Look look;
    look.id = "small";
    look.name = "Small";
    look.driven_by = Driver::signal;
    look.default_signal = Spec{"lissajous", {{"x", 3.0}}};
    look.parameters = {parameter_named("decay", 0.92), parameter_named("exposure", 1.5)};
    return look;
}
}  // namespace

TEST_CASE("a drag is one undo step") {
    Document document(document_look());
    document.set_value("decay", Value(0.5), true);
    document.set_value("decay", Value(0.6), true);
    document.set_value("decay", Value(0.7), true);
    document.finish();
    document.set_value("decay", Value(0.8), true);
    document.finish();

    document.undo();
    CHECK(document.values().at("decay") == Value(0.7));
    document.undo();
    CHECK(document.values().empty());
    document.redo();
    CHECK(document.values().at("decay") == Value(0.7));
}

TEST_CASE("a value beyond the hard limit is clamped") {
    Document document(document_look());
    document.set_value("exposure", Value(1e9));
    CHECK(document.values().at("exposure") == Value(10.0));
    document.set_value("exposure", Value(std::nan("")));
    CHECK(document.values().count("exposure") == 0);  // NaN: the default
}

TEST_CASE("a value that returns to its default is not a change") {
    Document document(document_look());
    document.set_value("decay", Value(0.5));
    CHECK(is_modified(document));
    document.set_value("decay", Value(0.92));
    CHECK(document.values().empty());
    CHECK_FALSE(is_modified(document));
}

TEST_CASE("several values are set in one step, each within its limit") {
    Document document(document_look());
    set_values(document, {{"decay", Value(0.5)}, {"exposure", Value(99.0)}, {"gone", Value(1.0)}},
               "Both");
    CHECK(document.values() == Values{{"decay", Value(0.5)}, {"exposure", Value(10.0)}});
    CHECK(document.history().undo_name() == "Both");
    document.undo();
    CHECK(document.values().empty());
}

TEST_CASE("reset affects one parameter or all") {
    Document document(document_look());
    document.set_value("decay", Value(0.5));
    document.set_value("exposure", Value(3.0));
    reset_parameters(document, {"decay"});
    CHECK(document.values() == Values{{"exposure", Value(3.0)}});
    CHECK(document.history().undo_name() == "Reset Decay");
    reset_all_parameters(document);
    CHECK(document.values().empty());
    document.undo();
    CHECK(document.values() == Values{{"exposure", Value(3.0)}});
}

TEST_CASE("an edited look keeps, renames and stores lost values in the whole history") {
    Document document(document_look());
    document.set_value("decay", Value(0.5));
    document.set_value("exposure", Value(3.0));
    Look edited = document_look();
    edited.parameters = {parameter_named("persistence", 0.9)};
    edited.parameters[0].was = "decay";
    document.replace_look(edited);

    CHECK(document.values() == Values{{"persistence", Value(0.5)}, {"exposure", Value(3.0)}});
    CHECK(orphans(document.look(), document.values()) == std::vector<std::string>{"exposure"});
    document.undo();
    CHECK(document.values() == Values{{"persistence", Value(0.5)}});

    document.replace_look(document_look());  // the uniform is back under its old name
    document.redo();
    CHECK(document.values().at("exposure") == Value(3.0));
}

TEST_CASE("a preset opens unmodified and keeps its name and orphans when changed") {
    Document document(document_look());
    Preset preset;
    preset.look = "small";
    preset.name = "Night";
    preset.values = {{"decay", Value(0.99)}, {"gone", Value(1.0)}};
    open_preset(document, preset, "night.json");
    CHECK_FALSE(is_modified(document));
    CHECK(document.state().signal == *document_look().default_signal);
    document.set_value("exposure", Value(2.0));
    CHECK(is_modified(document));

    const Preset saved = preset_of(document);
    CHECK(saved.name == "Night");
    CHECK(saved.values ==
          Values{{"decay", Value(0.99)}, {"exposure", Value(2.0)}, {"gone", Value(1.0)}});
    CHECK(saved.digest == look_digest(document_look()));
    CHECK(complete_preset_of(document).values.size() == 3);
}

TEST_CASE("opening a preset is one step, and undo restores unsaved values and the preset") {
    Document document(document_look());
    Preset night;
    night.name = "Night";
    night.values = {{"decay", Value(0.99)}};
    open_preset(document, night, "night.json");
    document.set_value("exposure", Value(2.0));
    Preset day;
    day.name = "Day";
    day.values = {{"decay", Value(0.5)}};
    open_preset(document, day, "day.json");
    CHECK(document.history().undo_name() == "Open Day");
    CHECK_FALSE(is_modified(document));

    document.undo();
    CHECK(document.values() == Values{{"decay", Value(0.99)}, {"exposure", Value(2.0)}});
    CHECK(preset_name(document) == "Night");
    CHECK(preset_file(document) == "night.json");
    CHECK(is_modified(document));  // compared with Night again, not with Day
    document.redo();
    CHECK(preset_file(document) == "day.json");
    CHECK_FALSE(is_modified(document));
    open_defaults(document);
    CHECK(document.values().empty());
    CHECK(preset_file(document).empty());
    document.undo();
    CHECK(preset_name(document) == "Day");
}

TEST_CASE("a renamed or saved preset has its new name in the whole history") {
    Document document(document_look());
    Preset preset;
    preset.name = "Night";
    open_preset(document, preset, "night.json");
    document.set_value("decay", Value(0.5));
    preset.name = "Dawn";
    opened_preset(document) = {preset, "dawn.json", document.state()};
    document.undo();
    CHECK(preset_file(document) == "dawn.json");
    CHECK(is_modified(document));
}

TEST_CASE("opening the current, unchanged preset adds no undo step") {
    Document document(document_look());
    open_defaults(document);
    CHECK_FALSE(document.history().can_undo());
}

TEST_CASE("pass overrides belong to the look, not to the preset") {
    Look look = document_look();
    look.passes.resize(1);
    look.passes[0].name = "beam";
    Document document(look);
    set_override(document, "beam", {Format::r32f, 0.25, {}});
    CHECK(document.drawn_look().passes[0].format == Format::r32f);
    CHECK(document.drawn_look().passes[0].size[0].factor == 0.25);
    CHECK_FALSE(is_modified(document));
    document.undo();
    CHECK(document.drawn_look() == look);
}

TEST_CASE("a drag of the camera is one undo step and is stored in the preset") {
    Look look = document_look();
    for (Parameter& part : orbit_parameters({}, {0}))
        look.parameters.push_back(std::move(part));
    Document document(look);
    for (int i = 0; i < 3; ++i)
        set_orbit(document, [](const Orbit& orbit) { return with_camera_moved(orbit, -10, -5); });
    document.finish();
    CHECK(preset_of(document).values ==
          Values{{"orbit_azimuth", Value(30.0)}, {"orbit_elevation", Value(15.0)}});
    CHECK(document.history().undo_name() == "View");
    document.undo();
    CHECK(document.values().empty());
}

TEST_CASE("locked values stay when many values change at once") {
    Document document(document_look());
    document.set_value("decay", Value(0.5));
    document.set_value("exposure", Value(3.0));
    set_parameter_setting(document, "decay", {.is_locked = true});
    SUBCASE("reset of a group") {
        reset_group(document, {"decay", "exposure"});
        CHECK(document.values() == Values{{"decay", Value(0.5)}});
    }
    SUBCASE("reset of all") {
        reset_all_parameters(document);
        CHECK(document.values() == Values{{"decay", Value(0.5)}});
    }
    SUBCASE("a preset, from which the document then differs") {
        Preset preset;
        preset.look = "small";
        preset.values = {{"decay", Value(0.1)}, {"exposure", Value(0.2)}};
        open_preset(document, preset, "preset.json");
        CHECK(document.values() == Values{{"decay", Value(0.5)}, {"exposure", Value(0.2)}});
        CHECK(is_modified(document));
    }
    SUBCASE("the look's defaults") {
        open_defaults(document);
        CHECK(document.values() == Values{{"decay", Value(0.5)}});
    }
    SUBCASE("pasted values") {
        apply_preset(document, {}, "Paste");
        CHECK(document.values() == Values{{"decay", Value(0.5)}});
    }
    SUBCASE("randomise") {
        randomise_parameters(document, {.seed = 1});
        CHECK(document.values().at("decay") == Value(0.5));
    }
    document.undo();
    CHECK(document.values().at("exposure") == Value(3.0));
    reset_parameters(document, {"decay"});  // resetting the parameter itself still works
    CHECK(document.values().count("decay") == 0);
}

TEST_CASE("randomise is one undo step") {
    Document document(document_look());
    randomise_parameters(document, {.seed = 1});
    CHECK(document.values().size() == 2);
    CHECK(document.history().undo_name() == "Randomise");
    document.undo();
    CHECK(document.values().empty());
    CHECK_FALSE(document.history().can_undo());
}

TEST_CASE("a lock follows its parameter through a rename") {
    Document document(document_look());
    set_parameter_setting(document, "decay", {.is_locked = true});
    Look edited = document_look();
    edited.parameters[0].name = "glow";
    edited.parameters[0].was = "decay";
    document.replace_look(edited);
    CHECK(document.parameter_settings() == ParameterSettings{{"glow", {.is_locked = true}}});
}
