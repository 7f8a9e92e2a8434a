#include "model/preset/preset.h"

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

TEST_CASE("a preset of the current version of a look gives no warnings") {
    Preset preset;
    preset.values = {{"decay", 0.5}};
    preset.digest = look_digest(phosphor());
    CHECK(compare_with_look(preset, phosphor(), "p.json").empty());
    preset.digest.clear();
    CHECK(compare_with_look(preset, phosphor(), "p.json").empty());
}

TEST_CASE("a value without a parameter is reported, with a suggestion") {
    Preset preset;
    preset.values = {{"dekay", 0.5}};
    const Diagnostics notes = compare_with_look(preset, phosphor(), "p.json");
    REQUIRE(notes.size() == 1);
    CHECK(
        to_string(notes.front()) ==
        "p.json: warning: 'Phosphor' no longer has the parameter 'dekay' (did you mean 'decay'?). "
        "Its value 0.5 is kept.");
}

TEST_CASE("changed defaults are reported even when every name still exists") {
    Preset preset;
    preset.digest = "00000000";
    CHECK(compare_with_look(preset, phosphor(), "p.json").size() == 1);
}

namespace {
// A look with these parameters: name and default.
Look with(const std::vector<std::pair<std::string, double>>& parameters) {
    Look look;
    look.name = "Phosphor";
    for (const auto& [name, initial] : parameters) {
        Parameter parameter;
        parameter.name = name;
        parameter.initial = initial;
        look.parameters.push_back(parameter);
    }
    return look;
}
}  // namespace

TEST_CASE("parameters added since a preset was saved give no warning") {
    const Look before = with({{"decay", 0.9}, {"gain", 1.0}});
    Look now = before;
    Preset preset;
    preset.digest = look_digest(before);
    for (int i = 0; i < 40; ++i) {
        Parameter added;
        added.name = "added_" + std::to_string(i);
        added.initial = 0.5;
        now.parameters.insert(now.parameters.begin(), added);
    }
    CHECK(compare_with_look(preset, now, "p.json").empty());
}

TEST_CASE("a removed, renamed or changed parameter gives one warning") {
    Preset preset;
    preset.digest = look_digest(with({{"decay", 0.9}, {"gain", 1.0}}));
    for (const Look& now : {with({{"decay", 0.9}}), with({{"decay", 0.9}, {"level", 1.0}}),
                            with({{"decay", 0.8}, {"gain", 1.0}}),
                            with({{"decay", 0.8}, {"gain", 1.0}, {"added", 0.0}})})
        CHECK(compare_with_look(preset, now, "p.json").size() == 1);
}

TEST_CASE("digests of older versions are accepted, also after parameters were added") {
    // Written by a version whose digests had no part for each parameter: FNV-1a, 64 bits, of
    // "decay=0.9\ngain=1\n", folded to 32 bits.
    Preset preset;
    preset.digest = "d70b80e1";
    CHECK(compare_with_look(preset, with({{"gain", 1.0}, {"decay", 0.9}}), "p.json").empty());
    CHECK(compare_with_look(preset, with({{"a", 1.0}, {"decay", 0.9}, {"gain", 1.0}}), "p.json")
              .empty());
    CHECK(compare_with_look(preset, with({{"a", 1.0}, {"decay", 0.9}, {"gain", 1.0}, {"z", 2.0}}),
                            "p.json")
              .empty());
    CHECK(compare_with_look(preset, with({{"decay", 0.8}, {"gain", 1.0}}), "p.json").size() == 1);
    CHECK(compare_with_look(preset, with({{"decay", 0.9}}), "p.json").size() == 1);
}
