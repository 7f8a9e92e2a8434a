// Presets of looks from other programs or outside the library.
#include "lab/document/opened_preset.h"
#include "lab/library/library_view.h"
#include "lab/small_lab.h"

namespace {
constexpr const char* level_frag = R"(#version 330
const float LEVEL = 0.25;  // @range 0 1
out vec4 color;
void main() { color = vec4(LEVEL); }
)";

/// A lab with an open shader from a folder outside the library.
class LabElsewhere : public SmallLab {
public:
    LabElsewhere() {
        write("../../elsewhere/level.frag", level_frag);
        lab().looks().open((folder() / "elsewhere/level.frag").string());
        REQUIRE(update_until([&] { return is_open(""); }));
    }
    bool is_open(const std::string& preset) {
        return !lab().loader().is_loading() && document().look().id == "level.frag" &&
               preset_name(document()) == preset;
    }
    double level() { return document().value(document().look().parameters.front()).number(); }
    void set_level(double value) {
        lab().edit([value](Document& changed) {
            changed.set_value("LEVEL", Value(value));
            changed.finish();
        });
    }
};

std::vector<std::string> presets_of(const ListedLook& look) {
    std::vector<std::string> names;
    for (const ListedLookPreset& preset : look.presets)
        names.push_back(preset.name);
    return names;
}
}  // namespace

TEST_CASE("an open look outside the library is listed last") {
    LabElsewhere elsewhere;
    elsewhere.set_level(0.75);
    elsewhere.lab().presets().save_as("Lighter");
    LibraryView library_view;
    library_view.update(elsewhere.lab().work().library, nullptr, 0.0);
    REQUIRE(library_view.looks().size() == 1);
    CHECK(library_view.looks()[0].entry.id == "small");
    const Look& open = elsewhere.document().look();
    library_view.update(elsewhere.lab().work().library, &open, 0.0);
    REQUIRE(library_view.looks().size() == 2);
    CHECK_FALSE(is_listed_as(open, library_view.looks()[0]));
    CHECK(is_listed_as(open, library_view.looks()[1]));
    CHECK(presets_of(library_view.looks()[1]) == std::vector<std::string>{"Lighter"});
    CHECK(library_view.looks()[1].argument() == argument_of(open));
}

TEST_CASE("a preset of a look from another program opens, and so do its defaults") {
    LabElsewhere elsewhere;
    elsewhere.set_level(0.75);
    elsewhere.lab().presets().save_as("Lighter");
    REQUIRE(elsewhere.is_open("Lighter"));
    elsewhere.lab().presets().navigation().step(1);  // from the last preset to the look's defaults
    CHECK(elsewhere.update_until([&] { return elsewhere.is_open(""); }));
    CHECK(elsewhere.level() == 0.25);
    elsewhere.lab().presets().navigation().step(1);
    CHECK(elsewhere.update_until([&] { return elsewhere.is_open("Lighter"); }));
    CHECK(elsewhere.level() == 0.75);
    CHECK(elsewhere.lab().messages().problems().empty());
}
