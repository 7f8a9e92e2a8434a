#include "formats/preset/preset_format.h"
#include "formats/preset/sample_preset.h"
#include "formats/scene/scene_file.h"
#include "in_a_moment.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace {
const std::string preset_head = "{\"format\": \"afterglow-preset\", \"version\": 1,\n\"look\": ";

std::string refusal(const std::string& text) {
    const auto preset = parse_preset(text, "a.json");
    REQUIRE_FALSE(preset.has_value());
    return to_string(preset.error().front());
}

std::string values(int count) {
    std::string text = "\"values\": {";
    for (int i = 0; i < count; ++i)
        text += fmt::format("{}\"v{}\": 1", i == 0 ? "" : ",", i);
    return text + "}";
}

std::string scene_refusal(const std::string& items) {
    const auto scene = parse_scene(
        "{\"format\": \"afterglow-scene\", \"version\": 1,\n\"items\": [" + items + "]}", "s.json");
    REQUIRE_FALSE(scene.has_value());
    return to_string(scene.error().front());
}
}  // namespace

TEST_CASE("a preset with too many looks is rejected before its keys are compared") {
    std::string message;
    const std::string looks = times(20'000, "a+");
    CHECK(is_done_in_a_moment([&] {
        message = refusal(preset_head + "\"" + looks + "a\", \"bypass\": [" +
                          times(20'000, "\"b\",") + "\"b\"]}");
    }));
    CHECK(message == "a.json:2: error: the stack has 20001 looks; the limit is 64");
    CHECK(refusal(preset_head + "\"a+b\", \"bypass\": [\"a\", \"b\", \"a\"]}") ==
          "a.json:2: error: 'bypass' lists 3 looks, but the stack has only 2");
}

TEST_CASE("a preset has at most 65,536 values") {
    CHECK(parse_preset(preset_head + "\"a\", " + values(65'536) + "}", "a.json").has_value());
    CHECK(refusal(preset_head + "\"a\", " + values(65'537) + "}") ==
          "a.json:2: error: the preset has 65537 values; the limit is 65536");
}

TEST_CASE("a preset file is read once to locate all its errors") {
    const TemporaryFolder folder;
    Look look = sample_look();
    std::string text = preset_head + "\"phosphor\", \"values\": {";
    for (int i = 0; i < 200; ++i) {
        Parameter parameter = look.parameters.front();
        parameter.name = fmt::format("bad{}", i);
        look.parameters.push_back(parameter);
        text += fmt::format("\n\"bad{}\": [1, 2],", i);
    }
    for (int i = 0; i < 60'000; ++i)
        text += fmt::format("\"unknown{}\": 1,", i);
    text += "\"decay\": 0.5}}";
    const auto file = folder.write("a.json", text);
    const auto preset = load_preset(file);
    REQUIRE(preset.has_value());
    CHECK(is_done_in_a_moment([&] {
        const auto fitted = fitted_values(look, *preset, file);
        REQUIRE_FALSE(fitted.has_value());
        CHECK(fitted.error().size() == 200);
        CHECK(fitted.error().front().line == 3);  // values are in the order of their names
    }));
}

TEST_CASE("a scene with too many points is rejected at the first excess item") {
    // A grid of 200 x 200 has 201 lines in each direction, with 2 points each.
    const std::string grid = "\n{\"shape\": \"grid\", \"columns\": 200, \"rows\": 200},";
    const std::size_t fitting = 400'000 / (2 * 201 * 2);
    const std::string dot = "\n{\"shape\": \"dot\"}";
    const auto good =
        parse_scene("{\"format\": \"afterglow-scene\", \"version\": 1,\n\"items\": [" +
                        times(fitting, grid) + dot + "]}",
                    "s.json");
    CHECK(good.has_value());
    CHECK(scene_refusal(times(20'000, grid) + dot) ==
          fmt::format(
              "s.json:{}: error: too many points up to this item; the limit is 400000. Remove "
              "or simplify items.",
              fitting + 3));
    CHECK(scene_refusal("{\"shape\": \"text\", \"text\": \"" + times(16'385, "A") + "\"}") ==
          "s.json:2: error: 'text' has 16385 bytes; the limit is 16384. Split it into several "
          "items.");
}
