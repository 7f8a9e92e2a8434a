#include "formats/preset/modulation_format.h"

#include "formats/preset/preset_format.h"
#include "formats/preset/preset_png.h"
#include "formats/preset/sample_preset.h"
#include "formats/preset/share_line.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace {
Preset moving_preset() {
    Preset preset = sample_preset();
    preset.modulations = {
        {"bloom_intensity",
         {.kind = ModulationKind::envelope, .depth = 0.5, .attack = 0.02, .release = 0.25}},
        {"decay", {.depth = -0.1, .shape = LfoShape::random, .rate = 2.0, .phase = 0.75}},
        {"gone", {.kind = ModulationKind::beat, .depth = 1.0, .release = 0.1, .threshold = 3.0}}};
    return preset;
}

const std::string moving_text =
    R"(  "modulation": {
    "bloom_intensity": {
      "kind": "envelope",
      "attack": 0.02,
      "release": 0.25,
      "depth": 0.5
    },
    "decay": {
      "kind": "lfo",
      "shape": "random",
      "rate": 2,
      "phase": 0.75,
      "depth": -0.1
    },
    "gone": {
      "kind": "beat",
      "threshold": 3,
      "release": 0.1,
      "depth": 1
    }
  }
}
)";

std::string modulation_errors(const std::string& modulation) {
    const auto preset = parse_preset(
        "{\"format\": \"afterglow-preset\", \"version\": 1, \"look\": \"phosphor\",\n" +
            modulation + "}",
        "a.json");
    REQUIRE_FALSE(preset.has_value());
    return to_string(preset.error());
}
}  // namespace

TEST_CASE("modulation is the last key of a preset, and is kept in files, share lines and PNGs") {
    const Preset preset = moving_preset();
    const std::string text = preset_to_json(preset);
    CHECK(text.ends_with("  },\n" + moving_text));
    CHECK(parse_preset(text, "a.json") == preset);
    CHECK(parse_share_line(share_line(preset)) == preset);
    CHECK(preset_to_json(sample_preset()).find("modulation") == std::string::npos);
}

TEST_CASE("missing keys of a modulation have their defaults") {
    const auto preset = parse_preset(
        R"({"format": "afterglow-preset", "version": 1, "look": "a",
            "modulation": {"decay": {"kind": "beat"}}})",
        "a.json");
    REQUIRE(preset.has_value());
    CHECK(preset->modulations == Modulations{{"decay", {.kind = ModulationKind::beat}}});
}

TEST_CASE("errors in a modulation are reported at their lines") {
    CHECK(modulation_errors(
              "\"modulation\": {\"a\": {\n\"kind\": \"lfo\",\n\"rate\": -1,\n\"attack\": "
              "2}}") ==
          "a.json:4: error: 'rate' must be between 0.001 and 1000, got -1\n"
          "a.json:5: error: unknown key 'attack'\n");
    CHECK(modulation_errors("\"modulation\": {\"a\": {},\n\"b\": 3,\n\"c\": {\"kind\": \"lf\"}}")
              .starts_with("a.json:2: error: 'kind' is missing\n"
                           "a.json:3: error: 'b' must be an object {...}, got 3\n"
                           "a.json:4: error: "));
    CHECK(modulation_errors("\"modulation\": {\"a\": {\"kind\": \"lfo\", \"shape\": \"box\"}}")
              .find("unknown value 'box' for 'shape'") != std::string::npos);
    CHECK(modulation_errors("\"modulation\": []").starts_with("a.json:2: error: "));
}

TEST_CASE(
    "a modulation follows a renamed parameter, and an unsuitable one is an error at its line") {
    const TemporaryFolder folder;
    Preset preset = sample_preset();
    preset.modulations = {{"bloom_strength", {}}, {"gone", {}}};
    const auto fitted = fitted_modulations(sample_look(), preset, "none.json");
    CHECK(fitted == Modulations{{"bloom_intensity", {}}, {"gone", {}}});
    preset.modulations = {{"tone_map", {}}};
    const auto file = folder.write("a.json", "{\"a\": 1,\n\"modulation\": {\n\"tone_map\": {}}}");
    const auto refused = fitted_modulations(sample_look(), preset, file);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().front().line == 3);
    CHECK(refused.error().front().message == "'tone_map' can't be modulated: it is a list");
    const Diagnostics notes = compare_with_look(moving_preset(), sample_look(), file);
    REQUIRE(notes.size() == 1);
    CHECK(notes.front().message.find("Its modulation is kept.") != std::string::npos);
}

TEST_CASE("a modulation in beats and its tempo survive the preset") {
    Preset preset = sample_preset();
    preset.modulations = {{"decay", {.depth = 0.5, .is_in_beats = true, .period = 8.0}},
                          {"gone",
                           {.kind = ModulationKind::envelope,
                            .is_in_beats = true,
                            .attack_beats = 0.25,
                            .release_beats = 2.0}}};
    preset.tempo = Tempo{127.5, 0.25, 3.0};
    const std::string text = preset_to_json(preset);
    CHECK(text.find("\"unit\": \"beats\"") != std::string::npos);
    CHECK(parse_preset(text, "a.json") == preset);
    const auto line = parse_share_line(share_line(preset));
    REQUIRE(line.has_value());
    CHECK(line->tempo == preset.tempo);
}

TEST_CASE("errors in a tempo and in beats are reported at their lines") {
    CHECK(modulation_errors("\"tempo\": {\"bpm\": 1000,\n\"beat\": 2}") ==
          "a.json:2: error: 'bpm' must be between 20 and 400, got 1000\n"
          "a.json:3: error: unknown key 'beat' (did you mean 'beats_per_bar'?)\n");
    CHECK(modulation_errors("\"modulation\": {\"a\": {\"kind\": \"lfo\", \"unit\": \"bars\"}}")
              .find("unknown value 'bars' for 'unit'") != std::string::npos);
    CHECK(modulation_errors("\"modulation\": {\"a\": {\"kind\": \"lfo\", \"unit\": \"beats\",\n"
                            "\"rate\": 2}}") == "a.json:3: error: unknown key 'rate'\n");
}
