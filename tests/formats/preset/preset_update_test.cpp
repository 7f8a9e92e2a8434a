#include "formats/preset/preset_update.h"

#include "base/file.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/sample_preset.h"
#include "formats/preset/share_line.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

namespace {
// A manually written preset with its own order, spaces and digits.
const std::string handmade =
    R"({ "format": "afterglow-preset", "version": 1,
  "look":   "phosphor", "name": "Mine",
  "signal": { "kind": "lissajous", "x": 3, "y": 2.50 },
  "values": {
    "tone_map": 2,
    "decay":    0.9400,
    "as_written": true
  }
}
)";

// The preset as a document has it, with values fitted to the look.
Preset opened(const std::string& text) {
    auto preset = parse_preset(text, "a.json");
    REQUIRE(preset.has_value());
    preset->values = fitted_values(sample_look(), *preset, "a.json").value();
    return *preset;
}

std::string updated(const std::string& text, const Preset& preset) {
    const Look look = sample_look();
    return updated_preset_text(text, preset, &look);
}
}  // namespace

TEST_CASE("an unchanged preset keeps every byte") {
    CHECK(updated(handmade, opened(handmade)) == handmade);
}

TEST_CASE("only changed values are rewritten") {
    Preset preset = opened(handmade);
    preset.values["decay"] = Value(0.5);
    preset.signal->settings["x"] = 4.0;
    std::string expected = handmade;
    expected.replace(expected.find("0.9400"), 6, "0.5");
    expected.replace(expected.find("\"x\": 3"), 6, "\"x\": 4");
    CHECK(updated(handmade, preset) == expected);
}

TEST_CASE("a number with the same 32-bit float keeps its digits") {
    Preset preset = opened(handmade);
    preset.values["decay"] = Value(static_cast<double>(0.94f));
    CHECK(updated(handmade, preset) == handmade);
}

TEST_CASE("new members are inserted in sorted order, and removed ones leave no gap") {
    Preset preset = opened(handmade);
    preset.author = "Ada";
    preset.values["bloom_intensity"] = Value(0.25);
    preset.values["points"] = Value(100.0);
    preset.values.erase("as_written");
    CHECK(updated(handmade, preset) ==
          R"({ "format": "afterglow-preset", "version": 1,
  "look":   "phosphor", "name": "Mine",
  "author": "Ada",
  "signal": { "kind": "lissajous", "x": 3, "y": 2.50 },
  "values": {
    "bloom_intensity": 0.25,
    "points": 100,
    "tone_map": 2,
    "decay":    0.9400
  }
}
)");
}

TEST_CASE("a changed signal stays on its line") {
    Preset preset = opened(handmade);
    preset.signal = Spec{"waveform", {}};
    CHECK(updated(handmade, preset).find("\"signal\": { \"kind\": \"waveform\" },") !=
          std::string::npos);
    preset.signal.reset();
    CHECK(updated(handmade, preset).find("signal") == std::string::npos);
}

TEST_CASE("the written text parses to the preset, whatever the previous text was") {
    const std::vector<std::string> texts{
        handmade, "no JSON", "{}", R"({"format":"afterglow-preset","version":1,"look":"phosphor"})",
        R"({"format":"afterglow-preset","version":1,"look":"phosphor","values":{}})"};
    Preset preset = opened(handmade);
    preset.values = {{"decay", Value(0.25)}, {"tone_map", Value(0.0)}, {"orphan", Value(3.0)}};
    preset.about = "New \"words\"";
    for (const std::string& text : texts) {
        CAPTURE(text);
        CHECK(opened(updated(text, preset)) == preset);
    }
}

TEST_CASE("saving over a file keeps its formatting") {
    const TemporaryFolder folder;
    const auto file = folder.write("mine.json", handmade);
    Preset preset = opened(handmade);
    preset.name = "Ours";
    const Look look = sample_look();
    REQUIRE(save_preset(file, preset, &look).has_value());
    std::string expected = handmade;
    expected.replace(expected.find("Mine"), 4, "Ours");
    CHECK(read_text(file) == expected);
}

TEST_CASE("numbers are written with the fewest digits that parse to the same 32-bit float") {
    const Look look = sample_look();
    for (const auto& [number, digits] :
         std::vector<std::pair<double, std::string>>{{1.6260000000000001, "1.626"},
                                                     {static_cast<double>(1.626f), "1.626"},
                                                     {0.0005, "0.0005"},
                                                     {1.0 / 3.0, "0.33333334"},
                                                     {1e-9, "1e-09"},
                                                     {16777217.0, "16777217"},
                                                     {-0.1, "-0.1"}}) {
        Preset preset = sample_preset();
        preset.values = {{"bloom_intensity", Value(number)}};
        const std::string text = preset_to_json(preset, &look);
        CHECK(text.find("\"bloom_intensity\": " + digits + "\n") != std::string::npos);
        CHECK(static_cast<float>(opened(text).values.at("bloom_intensity").number()) ==
              static_cast<float>(number));
    }
}

TEST_CASE("list items are written by label, in files and share lines") {
    const Look look = sample_look();
    Preset preset = sample_preset();
    preset.values = {{"tone_map", Value(2.0)}};
    CHECK(preset_to_json(preset, &look).find("\"tone_map\": \"ACES\"") != std::string::npos);
    const auto line = parse_share_line(share_line(preset, &look));
    REQUIRE(line.has_value());
    CHECK(line->values.at("tone_map") == Value::of_path("ACES"));
    CHECK(fitted_values(look, *line, "a.json")->at("tone_map") == Value(2.0));
}

TEST_CASE("an ambiguous item label is written as its number") {
    Look look = sample_look();
    look.parameters[4].items = {{0, "Same"}, {1, "same"}, {2, "One, two"}};
    Preset preset = sample_preset();
    for (const double item : {1.0, 2.0}) {
        preset.values = {{"tone_map", Value(item)}};
        const auto read = parse_preset(preset_to_json(preset, &look), "a.json");
        CHECK(fitted_values(look, *read, "a.json")->at("tone_map") == Value(item));
    }
}

TEST_CASE("previous labels of items are accepted") {
    Look look = sample_look();
    look.parameters[4].items = {{0, "Clip", "Clamp"}, {1, "Reinhard"}, {2, "ACES"}};
    Preset preset = sample_preset();
    preset.values = {{"tone_map", Value::of_path("Clamp")}};
    CHECK(fitted_values(look, preset, "a.json")->at("tone_map") == Value(0.0));
    CHECK(parse_value(look.parameters[4], "clamp") == Value(0.0));
    preset.values = {{"tone_map", Value(0.0)}};
    CHECK(preset_to_json(preset, &look).find("\"tone_map\": \"Clip\"") != std::string::npos);
}
