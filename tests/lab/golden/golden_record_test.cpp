#include "lab/golden/golden_record.h"

#include "base/text.h"
#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
GoldenRecord golden_example() {
    GoldenRecord record{.bounds = {3.0, 0.5},
                        .size = {64, 36},
                        .frames = 20,
                        .driver = {"Mesa", "llvmpipe \"1\"", "4.5"}};
    record.pictures["phosphor"] = {{64, 36}, 20, {}};
    record.pictures["phosphor--amber"] = {{32, 18}, 1, GoldenDriver{"NVIDIA", "H100", "4.6"}};
    return record;
}
}  // namespace

TEST_CASE("golden.json keeps bounds, driver, and size and frames of each picture") {
    const auto read = parse_golden_record(golden_record_text(golden_example()), "golden.json");
    REQUIRE_MESSAGE(read.has_value(), problems_of(read));
    CHECK(*read == golden_example());
    const auto defaults = parse_golden_record(golden_record_text({}), "golden.json");
    REQUIRE(defaults.has_value());
    CHECK(*defaults == GoldenRecord{});
}

TEST_CASE("without golden.json the defaults are used") {
    const auto record = load_golden_record("/nowhere/golden.json");
    REQUIRE(record.has_value());
    CHECK(record->bounds == GoldenBounds{2.0, 0.1});
    CHECK(record->size == Extent{320, 180});
}

TEST_CASE("errors in golden.json have their line") {
    const std::string text = golden_record_text(golden_example());
    const auto message_after = [&](std::string_view from, std::string_view to) {
        const auto read = parse_golden_record(replace_all(text, from, to), "golden.json");
        return read ? std::string() : to_string(read.error());
    };
    CHECK(message_after("\"3/255\"", "\"300\"")
              .starts_with("golden.json:4: error: 'max' must be a difference from 0 to 255/255, "
                           "got '300'"));
    CHECK(
        message_after("\"size\": \"64x36\"", "\"size\": 3").find("golden.json:6: error: 'size'") ==
        0);
    CHECK(message_after("\"phosphor\"", "\"../phosphor\"")
              .find("'../phosphor' can't be the name of a golden picture") != std::string::npos);
    CHECK(message_after("\"frames\": 1", "\"frames\": 0").find("'frames' must be a whole number") !=
          std::string::npos);
    CHECK(message_after("\"share\"", "\"shared\"").find("(did you mean 'share'?)") !=
          std::string::npos);
    CHECK_FALSE(parse_golden_record("{", "golden.json").has_value());
    CHECK_FALSE(parse_golden_record("", "golden.json").has_value());
}
