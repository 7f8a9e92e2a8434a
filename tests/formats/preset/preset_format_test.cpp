#include "formats/preset/preset_format.h"

#include "formats/preset/sample_preset.h"
#include "formats/preset/share_line.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <csignal>
#include <random>
#include <sys/wait.h>

namespace {
std::string preset_errors(std::string_view text) {
    const auto preset = parse_preset(text, "a.json");
    REQUIRE_FALSE(preset.has_value());
    return to_string(preset.error());
}

const std::string sample_text =
    R"({
  "format": "afterglow-preset",
  "version": 1,
  "look": "phosphor",
  "look_digest": "8c1f02aa",
  "name": "P31 bench scope",
  "about": "",
  "author": "",
  "signal": {
    "kind": "lissajous",
    "x": 3,
    "y": 2
  },
  "values": {
    "bloom_intensity": 0.8,
    "decay": 0.94
  }
}
)";
}  // namespace

TEST_CASE("a preset is written with one sorted key per line, and read back unchanged") {
    CHECK(preset_to_json(sample_preset()) == sample_text);
    CHECK(parse_preset(sample_text, "a.json") == sample_preset());
}

TEST_CASE("values of every type are written and read back unchanged") {
    Preset preset = sample_preset();
    preset.signal.reset();
    preset.source = "media/fr\xc3\xa4me \"1\".png";
    preset.media_digest = "0123";
    preset.values = {{"beam_color", Value({0.1, 1e-9, 3.0})},
                     {"crt#2/exposure", 0.33333334},
                     {"matrix", Value(std::vector<double>(16, -0.5))},
                     {"noise", Value::of_path("n\n.png")},
                     {"as_written", 1.0}};
    CHECK(parse_preset(preset_to_json(preset), "a.json") == preset);
    const Look look = sample_look();
    const std::string text = preset_to_json(preset, &look);
    CHECK(text.find("\"as_written\": true,") != std::string::npos);
    CHECK(text.find("\"beam_color\": [0.1, 1e-09, 3],") != std::string::npos);
    CHECK(parse_preset(text, "a.json") == preset);
}

TEST_CASE("the bare first setting of a signal is written under its own key") {
    Preset preset = sample_preset();
    preset.signal = parse_spec("audio:song.wav,mode=xy").value();
    const auto read = parse_preset(preset_to_json(preset), "a.json");
    REQUIRE(read.has_value());
    CHECK_FALSE(read->signal->settings.contains(""));
    CHECK(preset_to_json(*read) == preset_to_json(preset));
    CHECK(preset_to_json(*read).find("song.wav") != std::string::npos);
}

TEST_CASE("errors in a preset are reported at their lines") {
    CHECK(preset_errors("{\n\"format\": \"afterglow-preset\",\n\"version\": 2, \"values\": 3}") ==
          "a.json:3: error: format version 2 is too new; this version of Afterglow reads up to 1. "
          "Update "
          "Afterglow to open it.\n");
    CHECK(preset_errors(
              "{\"format\": \"afterglow-preset\", \"version\": 1,\n\"look\": \"\",\n\"nane\": "
              "\"x\",\n\"values\": {\"a\": 1,\n\"b\": null, \"c\": [],\n\"d\": [\"x\"], \"e\": "
              "{}}}") ==
          "a.json:2: error: 'look' is empty; set it to the name of a look\n"
          "a.json:5: error: 'b' must be a number, a list of 1 to 16 numbers, true, false or a "
          "text in quotes, got null\n"
          "a.json:5: error: 'c' must be a number, a list of 1 to 16 numbers, true, false or a "
          "text in quotes, got []\n"
          "a.json:6: error: 'd' must be a number, a list of 1 to 16 numbers, true, false or a "
          "text in quotes, got [...]\n"
          "a.json:6: error: 'e' must be a number, a list of 1 to 16 numbers, true, false or a "
          "text in quotes, got {}\n"
          "a.json:3: error: unknown key 'nane' (did you mean 'name'?)\n");
    const std::string head = "{\"format\": \"afterglow-preset\", \"version\": 1,\n";
    CHECK(preset_errors(head + "\"values\": {}}") == "a.json:1: error: 'look' is missing\n");
    CHECK(preset_errors(head + "\"look\": \"a\",\n\"signal\": {\"kind\": \"lisajous\"}}")
              .starts_with("a.json:3: error: "));
    CHECK(preset_errors(head + "\"look\": \"a\",\n\"signal\": {\n\"x\": true}}") ==
          "a.json:3: error: 'kind' is missing\na.json:4: error: 'x' must be a text in quotes, got "
          "true\n");
    CHECK(preset_errors(head + "\"look\": \"a\", \"values\": [1]}") ==
          "a.json:2: error: 'values' must be an object {...}, got [...]\n");
}

TEST_CASE("a preset is loaded from JSON and from a text file with a share line") {
    const TemporaryFolder folder;
    CHECK(load_preset(folder.write("a.json", sample_text)) == sample_preset());
    CHECK(load_preset(folder.write("a.txt", share_line(sample_preset()) + "\n")) ==
          sample_preset());
    const auto cut = load_preset(folder.write("b.txt", share_line(sample_preset()).substr(0, 60)));
    REQUIRE_FALSE(cut.has_value());
    CHECK(cut.error().front().file == folder / "b.txt");
}

TEST_CASE("an invalid preset is rejected with its file, and a line if possible") {
    const TemporaryFolder folder;
    const auto error_of = [&](const std::filesystem::path& file) {
        const auto preset = load_preset(file);
        REQUIRE_FALSE(preset.has_value());
        CHECK(preset.error().front().file == file);
        return preset.error().front().message;
    };
    CHECK(error_of(folder / "none.json") == "file not found");
    CHECK(error_of(folder.path()) == "this is a folder, not a file");
    CHECK(error_of(folder.write("a.json", "")) == "the file is empty");
    CHECK(error_of(folder.write("a.json", std::string("\0\1\2", 3)))
              .starts_with("this is not a text file"));
    CHECK(error_of(folder.write("a.json", std::string((16 << 20) + 1, ' ')))
              .starts_with("the file is too large"));
    CHECK(
        error_of(folder.write("a.json", std::string(1000, '['))).starts_with("nested too deeply"));
    CHECK(error_of(folder.write("a.json", "{}")) == "'format' is missing");
}

TEST_CASE("a truncated or randomly changed preset is read or rejected, but never partly read") {
    for (std::size_t size = 0; size + 2 < sample_text.size(); ++size) {
        const auto preset = parse_preset(sample_text.substr(0, size), "a.json");
        REQUIRE_FALSE(preset.has_value());
        CHECK(preset.error().front().file == "a.json");
        CHECK(preset.error().front().line >= 1);
    }
    std::mt19937 random(11);
    for (int trial = 0; trial < 20000; ++trial) {
        std::string damaged = sample_text;
        for (int change = 0; change < 1 + trial % 4; ++change)
            damaged[random() % damaged.size()] = static_cast<char>(random() % 96 + 32);
        const auto preset = parse_preset(damaged, "a.json");
        if (preset)
            CHECK(parse_preset(preset_to_json(*preset), "b.json") == preset);
        else
            CHECK(preset.error().front().line >= 1);
    }
}

TEST_CASE("after a kill during saving the file is the old or the new preset") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "presets/a.json";
    Preset preset = sample_preset();
    preset.about = std::string(100000, 'x');
    REQUIRE(save_preset(file, preset));
    std::mt19937 random(4);
    for (int trial = 0; trial < 40; ++trial) {
        const pid_t child = ::fork();
        if (child == 0)
            for (int round = 1;; ++round) {
                preset.values["decay"] = round;
                if (!save_preset(file, preset))
                    ::_exit(1);
            }
        ::usleep(static_cast<useconds_t>(random() % 10000));
        ::kill(child, SIGKILL);
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        CHECK(WIFSIGNALED(status));
        const auto loaded = load_preset(file);
        REQUIRE(loaded.has_value());
        CHECK(loaded->about == preset.about);
    }
}

TEST_CASE("values are fitted to the look: clamped, parsed from text and renamed") {
    Preset preset = sample_preset();
    preset.values = {{"decay", 1.5},
                     {"bloom_strength", 0.7},
                     {"points", 100.4},
                     {"as_written", 2.0},
                     {"tone_map", Value::of_path("aces")},
                     {"beam_color", Value::of_path("#ffff00")},
                     {"noise", Value::of_path("other.png")},
                     {"orphan", Value({1.0, 2.0})}};
    const auto values = fitted_values(sample_look(), preset, "none.json");
    REQUIRE(values.has_value());
    CHECK(*values == Values{{"decay", 1.0},
                            {"bloom_intensity", 0.7},
                            {"points", 100.0},
                            {"as_written", 1.0},
                            {"tone_map", 2.0},
                            {"beam_color", Value({1.0, 1.0, 0.0})},
                            {"noise", Value::of_path("other.png")},
                            {"orphan", Value({1.0, 2.0})}});
}

TEST_CASE("values that do not fit are errors at their lines of the preset") {
    const TemporaryFolder folder;
    const auto file =
        folder.write("a.json",
                     "{\"format\": \"afterglow-preset\", \"version\": 1, \"look\": "
                     "\"phosphor\", \"values\": {\n\"decay\": \"much\",\n\"beam_color\": "
                     "[1, 2],\n\"noise\": 3,\n\"bloom_strength\": [1, 2]}}");
    const auto preset = load_preset(file);
    REQUIRE(preset.has_value());
    const auto values = fitted_values(sample_look(), *preset, file);
    REQUIRE_FALSE(values.has_value());
    const std::string place = file.string();
    CHECK(to_string(values.error()) ==
          place + ":3: error: 'beam_color' must have 3 numbers, got 2\n" + place +
              ":5: error: 'bloom_intensity' must be a single number, got 2 numbers\n" + place +
              ":2: error: 'decay' must be a number, got 'much'\n" + place +
              ":4: error: 'noise' must be the path of a file, got numbers\n");
}

TEST_CASE("a shared preset contains every value of its look") {
    Preset preset = sample_preset();
    preset.values = {{"bloom_strength", 0.7}, {"orphan", 1.0}};
    const Preset whole = with_all_values(preset, sample_look());
    CHECK(whole.values.size() == sample_look().parameters.size() + 1);
    CHECK(whole.values.at("bloom_intensity") == Value(0.7));
    CHECK(whole.values.at("decay") == Value(0.92));
    CHECK(whole.values.at("orphan") == Value(1.0));
}
