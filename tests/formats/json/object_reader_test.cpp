#include "formats/json/object_reader.h"

#include <doctest/doctest.h>

namespace {
struct Reading {
    explicit Reading(std::string_view text)
        : document(parse_json(text, file).value()), reader(document, file, problems) {}

    std::filesystem::path file = "a.json";
    JsonValue document;
    Diagnostics problems;
    ObjectReader reader;
};
}  // namespace

TEST_CASE("members are read by type, and a missing member gives the fallback") {
    Reading reading(R"({"t": "text", "b": true, "n": 2.5, "w": 7, "c": "two"})");
    ObjectReader& reader = reading.reader;
    CHECK(reader.text("t") == "text");
    CHECK(reader.boolean("b", false));
    CHECK(reader.number("n", 0) == 2.5);
    CHECK(reader.whole("w", 0, 1, 9) == 7);
    CHECK(reader.choice("c", Choices<int>{{"one", 1}, {"two", 2}}, 0) == 2);
    CHECK(reader.text("none", "fallback") == "fallback");
    CHECK(reader.whole("nothing", 4, 1, 9) == 4);
    reader.report_unknown_keys();
    CHECK(reading.problems.empty());
}

TEST_CASE("every error is reported at its line") {
    Reading reading(
        "{\n\"t\": 1,\n\"b\": 0,\n\"n\": \"2\",\n\"w\": 2.5,\n\"v\": 10,\n\"c\": "
        "\"tvo\",\n\"tru\": 1}");
    ObjectReader& reader = reading.reader;
    CHECK(reader.text("t").empty());
    CHECK(reader.boolean("b", true));
    CHECK(reader.number("n", 5) == 5);
    CHECK(reader.whole("w", 6, 1, 9) == 6);
    CHECK(reader.whole("v", 6, 1, 9) == 6);
    CHECK(reader.choice("c", Choices<int>{{"one", 1}, {"two", 2}}, 0) == 0);
    reader.require("missing");
    reader.boolean("true", false);
    reader.report_unknown_keys();
    CHECK(
        to_string(reading.problems) ==
        "a.json:2: error: 't' must be a text in quotes, got 1\n"
        "a.json:3: error: 'b' must be true or false, got 0\n"
        "a.json:4: error: 'n' must be a number, got '2'\n"
        "a.json:5: error: 'w' must be a whole number between 1 and 9, got 2.5\n"
        "a.json:6: error: 'v' must be a whole number between 1 and 9, got 10\n"
        "a.json:7: error: unknown value 'tvo' for 'c' (did you mean 'two'?); use one of: one, two\n"
        "a.json:1: error: 'missing' is missing\n"
        "a.json:8: error: unknown key 'tru' (did you mean 'true'?)\n");
}

TEST_CASE("a value that is not an object gives one error") {
    Reading reading("[1]");
    CHECK(reading.reader.require("format") == nullptr);
    reading.reader.report_unknown_keys();
    CHECK(to_string(reading.problems) == "a.json:1: error: expected an object {...}, got [...]\n");
}

TEST_CASE("documents with another format or a newer version are rejected") {
    const auto refusal = [](std::string_view text) {
        Reading reading(text);
        const bool is_accepted = accept_header(reading.reader, {"afterglow-look", 2});
        CHECK(is_accepted == reading.problems.empty());
        return to_string(reading.problems);
    };
    CHECK(refusal(R"({"format": "afterglow-look", "version": 1})").empty());
    CHECK(refusal(R"({"format": "afterglow-look", "version": 2})").empty());
    CHECK(refusal("{\"format\": \"afterglow-look\",\n\"version\": 3}") ==
          "a.json:2: error: format version 3 is too new; this version of Afterglow reads up to 2. "
          "Update "
          "Afterglow to open it.\n");
    CHECK(refusal(R"({"format": "tar", "version": 1})") ==
          "a.json:1: error: 'format' must be 'afterglow-look', got 'tar'\n");
    CHECK(refusal(R"({"version": 0.5})") ==
          "a.json:1: error: 'format' is missing\n"
          "a.json:1: error: 'version' must be a whole number between 1 and 1000000, got 0.5\n");
}
