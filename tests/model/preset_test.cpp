#include "model/preset.h"

#include <doctest/doctest.h>

namespace {
Look phosphor() {
    Look look;
    look.name = "Phosphor";
    look.parameters.resize(1);
    look.parameters[0].name = "decay";
    look.parameters[0].initial = 0.9;
    return look;
}
}  // namespace

TEST_CASE("a preset of the present look has nothing to say") {
    Preset preset;
    preset.values = {{"decay", 0.5}};
    preset.digest = look_digest(phosphor());
    CHECK(compare_with_look(preset, phosphor(), "p.json").empty());
    preset.digest.clear();
    CHECK(compare_with_look(preset, phosphor(), "p.json").empty());
}

TEST_CASE("a value without a parameter is named, with a likely new name") {
    Preset preset;
    preset.values = {{"dekay", 0.5}};
    const Diagnostics notes = compare_with_look(preset, phosphor(), "p.json");
    REQUIRE(notes.size() == 1);
    CHECK(to_string(notes.front()) ==
          "p.json: warning: 'Phosphor' has no parameter 'dekay' any more; its value 0.5 is kept "
          "(did you mean 'decay'?)");
}

TEST_CASE("changed defaults are noted even when every name still fits") {
    Preset preset;
    preset.digest = "00000000";
    CHECK(compare_with_look(preset, phosphor(), "p.json").size() == 1);
}
