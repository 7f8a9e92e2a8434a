// Morphs between presets over time.
#include "formats/preset/preset_format.h"
#include "lab/document/morphing.h"
#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "lab/small_lab.h"

#include <cmath>

namespace {
class Going : public SmallLab {
public:
    std::filesystem::path preset(const char* look, Values values) {
        Preset preset;
        preset.look = look;
        preset.name = "Far";
        preset.values = std::move(values);
        auto file = folder() / "far.json";
        REQUIRE(save_preset(file, preset).has_value());
        return file;
    }
    double gain() { return document().value(*find_parameter(document().look(), "gain")).number(); }
};

bool is_near_on_way(double a, double b) {
    return std::abs(a - b) <= 1e-9;
}
}  // namespace

TEST_CASE("a morph takes its duration, is one undo step and is recorded as automation") {
    Going small;
    small.lab().player().pause();
    small.lab().presets().navigation().morph_to(small.preset("small", {{"gain", Value(5.0)}}), 2.0);
    REQUIRE(small.lab().presets().navigation().morphing());
    small.lab().update(0.5);
    CHECK(is_near_on_way(small.gain(), 2.0));  // a quarter of the way from 1 to 5
    CHECK(is_near_on_way(small.lab().presets().navigation().morphing()->share(), 0.25));
    small.lab().update(0.5);
    CHECK(is_near_on_way(small.gain(), 3.0));
    small.lab().automation().record(true);
    small.lab().player().play();
    small.lab().update(0.5);
    CHECK(small.lab().automation().recorder().points().back().name == "gain");
    CHECK(is_near_on_way(small.lab().automation().recorder().points().back().value.number(), 4.0));
    small.lab().update(0.75);
    CHECK_FALSE(small.lab().presets().navigation().morphing());
    CHECK(small.document().values() == Values{{"gain", Value(5.0)}});
    CHECK(small.document().history().undo_name() == "Morph to Far");
    CHECK(small.document().history().past().size() == 1);
    CHECK(preset_name(small.document()) == "Far");
    CHECK(preset_file(small.document()) == small.folder() / "far.json");
    CHECK_FALSE(is_modified(small.document()));
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(small.document().values().empty());
    CHECK(preset_name(small.document()).empty());
    CHECK_FALSE(is_modified(small.document()));
}

TEST_CASE("a morph leaves locked values alone, and a change by the user ends it") {
    Going small;
    small.lab().edit(
        [](Document& document) { set_parameter_setting(document, "gain", {.is_locked = true}); });
    const auto file = small.preset("small", {{"gain", Value(5.0)}, {"step_size", Value(3.0)}});
    small.lab().presets().navigation().morph_to(file, 1.0);
    small.lab().update(0.5);
    CHECK(is_near_on_way(small.gain(), 1.0));
    CHECK(small.document().values() == Values{{"step_size", Value(2.0)}});
    small.lab().edit([](Document& document) { document.set_value("gain", Value(6.0), true); });
    small.lab().update(0.25);
    small.lab().edit([](Document& document) { document.set_value("gain", Value(7.0), true); });
    small.lab().edit([](Document& document) { document.finish(); });
    small.lab().update(0.25);
    CHECK(small.document().history().past().size() == 2);  // the morph so far and the user's drag
    CHECK_FALSE(small.lab().presets().navigation().morphing());
    CHECK(small.document().values() == Values{{"gain", Value(7.0)}, {"step_size", Value(2.0)}});
}

TEST_CASE("a morph can be stopped halfway and works only within the same look") {
    Going small;
    small.lab().presets().navigation().morph_to(small.preset("small", {{"gain", Value(5.0)}}), 1.0);
    small.lab().update(0.5);
    small.lab().presets().navigation().end_morph();
    small.lab().update(0.5);
    CHECK(is_near_on_way(small.gain(), 3.0));
    CHECK_FALSE(small.document().history().is_in_gesture());
    CHECK(small.document().history().past().size() == 1);
    CHECK(preset_name(small.document()).empty());
    CHECK(is_modified(small.document()));
    small.lab().presets().navigation().morph_to(small.preset("small", {{"gain", Value(3.0)}}),
                                                60.0);
    small.lab().update(0.01);  // the values are equal already, so it opens immediately
    CHECK_FALSE(small.lab().presets().navigation().morphing());
    CHECK(preset_name(small.document()) == "Far");
    CHECK_FALSE(is_modified(small.document()));
    const auto refused = small.lab().presets().navigation().morph_to(
        small.preset("other", {{"gain", Value(3.0)}}), 1.0);
    CHECK_FALSE(small.lab().presets().navigation().morphing());
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().front().message ==
          "\"Far\" belongs to another look. It can be opened, but not morphed to.");
}

TEST_CASE("modulations change only when a morph is complete") {
    Going small;
    Preset preset;
    preset.look = "small";
    preset.name = "Breathing";
    preset.values = {{"gain", Value(2.0)}};
    preset.modulations = {{"step_size", Modulation{}}};
    const auto file = small.folder() / "breathing.json";
    REQUIRE(save_preset(file, preset).has_value());
    small.lab().presets().navigation().morph_to(file, 1.0);
    small.lab().update(0.5);
    CHECK(small.document().state().modulations.empty());
    small.lab().update(0.5);
    CHECK(small.document().state().modulations.contains("step_size"));
    CHECK_FALSE(is_modified(small.document()));
    small.lab().presets().navigation().morph_to("", 1.0);  // the look's defaults
    small.lab().update(2.0);
    CHECK(small.document().values().empty());
    CHECK(small.document().state().modulations.empty());
    CHECK(preset_file(small.document()).empty());
    CHECK_FALSE(is_modified(small.document()));
    small.lab().edit([](Document& document) { document.undo(); });
    CHECK(preset_name(small.document()) == "Breathing");
}

TEST_CASE("a morph targets the next preset, and a repeated one the preset after it") {
    Going small;
    for (const char* name : {"one", "two", "three"}) {
        small.lab().edit([&](Document& document) {
            document.set_value("gain", Value(static_cast<double>(std::string(name).size())));
        });
        small.lab().presets().save_as(name);
    }
    small.lab().presets().navigation().star("one", true);
    small.lab().presets().navigation().star("two", true);
    small.lab().presets().navigation().morph_by(1, 1.0);  // order by name: one, three, two
    CHECK(small.lab().presets().navigation().morphing()->name() == "two");
    small.lab().presets().navigation().morph_by(1, 1.0);
    CHECK(small.lab().presets().navigation().morphing()->name() == "Small");
    small.lab().presets().navigation().morph_by(1, 1.0, true);
    REQUIRE(small.lab().presets().navigation().morphing()->name() == "one");
    small.lab().update(1.0);
    CHECK(preset_name(small.document()) == "one");
    small.lab().presets().navigation().morph_by(1, 1.0, true);
    CHECK(small.lab().presets().navigation().morphing()->name() == "two");
    small.lab().presets().navigation().morph_to("", 0.5);
    small.lab().update(0.5);
    small.lab().presets().rename({}, "four");  // no preset is open: nothing happens
    CHECK(small.lab().presets().navigation().stars() == FavouritePresets{"small/one", "small/two"});
    small.lab().presets().navigation().morph_by(1, 0.5, true);
    small.lab().update(0.5);
    small.lab().presets().rename(preset_file(small.document()), "four");
    CHECK(small.lab().presets().navigation().stars() ==
          FavouritePresets{"small/four", "small/two"});
}
