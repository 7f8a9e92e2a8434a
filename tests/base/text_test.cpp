#include "base/text.h"

#include "in_a_moment.h"

#include <doctest/doctest.h>

TEST_CASE("a number is parsed the same in every locale, and the whole text must be a number") {
    CHECK(parse_number("0.92") == 0.92);
    CHECK(parse_number("+1e3") == 1000.0);
    CHECK_FALSE(parse_number("0,92").has_value());
    CHECK_FALSE(parse_number("1x").has_value());
    CHECK_FALSE(parse_number("").has_value());
    CHECK_FALSE(parse_number("nan").has_value());
    CHECK_FALSE(parse_number("1e999").has_value());
}

TEST_CASE("a float is written as the shortest text that parses to the same value") {
    CHECK(format_float(0.92f) == "0.92");
    CHECK(format_number(0.1) == "0.1");
}

TEST_CASE("lines end with LF or CRLF, and the last line end adds no empty line") {
    const auto lines = split_lines("a\r\nb\n\nc\n");
    REQUIRE(lines.size() == 4);
    CHECK(lines[0] == "a");
    CHECK(lines[2].empty());
    CHECK(lines[3] == "c");
    CHECK(split_lines("").empty());
    CHECK(split_lines("\r\n").size() == 1);
    CHECK(split_lines("a\n\r").size() == 2);
}

TEST_CASE("a name is suggested only when it is similar") {
    const std::vector<std::string> names{"decay", "exposure"};
    CHECK(did_you_mean("dacay", names) == " (did you mean 'decay'?)");
    CHECK(did_you_mean("vignette", names).empty());
    CHECK(did_you_mean("exp", names) == " (did you mean 'exposure'?)");
    CHECK(did_you_mean("decay", names).empty());
}

TEST_CASE("sentences are joined with exactly one full stop each") {
    CHECK(with_sentence("file not found", "'noise' shows black.") ==
          "file not found. 'noise' shows black.");
    CHECK(with_sentence("Is too large.", "Use another.") == "Is too large. Use another.");
}

TEST_CASE("a diagnostic has the format of a compiler message") {
    CHECK(to_string(Diagnostic{"mask.frag", 2, "unknown hint"}) ==
          "mask.frag:2: error: unknown hint");
    CHECK(to_string(Diagnostic{"mask.frag", 0, "is empty", Severity::warning}) ==
          "mask.frag: warning: is empty");
    CHECK(to_string(Diagnostic{{}, 0, "no GL"}) == "error: no GL");
}

TEST_CASE("each occurrence in a text is replaced, in linear time") {
    CHECK(replace_all("a+b++", "+", "%2B") == "a%2Bb%2B%2B");
    CHECK(replace_all("aaa", "aa", "a") == "aa");
    std::string changed;
    CHECK(is_done_in_a_moment(
        [&] { changed = replace_all(times(1'000'000, "iCh0.sampler;"), "iCh0.sampler", "x"); }));
    CHECK((changed == times(1'000'000, "x;")));
}
