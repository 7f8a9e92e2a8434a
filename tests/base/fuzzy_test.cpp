#include "base/fuzzy.h"

#include <doctest/doctest.h>

namespace {
int score(const char* query, const char* text) {
    const auto match = fuzzy_match(query, text);
    return match ? match->score : -1000;
}

std::vector<std::size_t> positions(const char* query, const char* text) {
    const auto match = fuzzy_match(query, text);
    return match ? match->positions : std::vector<std::size_t>{};
}
}  // namespace

TEST_CASE("a word matches as a substring, or as letters in order from the start of a word") {
    CHECK(positions("spa", "Save preset as") == std::vector<std::size_t>{0, 5, 12});
    CHECK(positions("RESET", "Save preset as") == std::vector<std::size_t>{6, 7, 8, 9, 10});
    CHECK(positions("prst", "Preset") == std::vector<std::size_t>{0, 1, 3, 5});
    CHECK(positions("bloom_int", "Bloom intensity") ==
          std::vector<std::size_t>{0, 1, 2, 3, 4, 6, 7, 8});
    CHECK_FALSE(fuzzy_match("rst", "Preset"));       // neither a substring nor the start of a word
    CHECK_FALSE(fuzzy_match("aps", "Save preset"));  // the wrong order
    CHECK_FALSE(fuzzy_match("save it", "Save preset"));
    CHECK_FALSE(fuzzy_match("long", "no"));
    CHECK_FALSE(fuzzy_match("a", ""));
    CHECK_FALSE(fuzzy_match("a", "Brass"));  // one letter matches any text that contains it
}

TEST_CASE("words match in any order, and an empty query matches everything") {
    CHECK(positions("pre sav", "Save preset") == std::vector<std::size_t>{0, 1, 2, 5, 6, 7});
    CHECK(fuzzy_match("", "Undo")->score == 0);
    CHECK(fuzzy_match("  ", "")->positions.empty());
}

TEST_CASE("consecutive letters score highest, then first letters of words") {
    CHECK(score("pre", "Preset") > score("pre", "Pass: reduced"));
    CHECK(score("sp", "Spot size") > score("sp", "Save preset"));
    CHECK(score("sp", "Save preset") > score("sp", "Show a depth"));
    CHECK(score("gain", "Gain") > score("gain", "Again"));
    CHECK(score("gain", "Again") > score("gain", "Grating"));
    // The best of several matches is used: the whole word, not its first letter further left.
    CHECK(positions("pa", "Play: pass") == std::vector<std::size_t>{6, 7});
}
