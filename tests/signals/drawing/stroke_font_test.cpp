#include "signals/drawing/stroke_font.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
std::vector<ScenePath> letter(std::string_view text) {
    return text_paths(text, 6.0, TextAlign::middle);
}

// The number of strokes of `whole` that are not in `part`.
std::size_t strokes_besides(const std::vector<ScenePath>& whole,
                            const std::vector<ScenePath>& part) {
    return static_cast<std::size_t>(std::ranges::count_if(
        whole, [&](const ScenePath& path) { return std::ranges::find(part, path) == part.end(); }));
}

double highest(const std::vector<ScenePath>& paths) {
    double maximum = -1e9;
    for (const ScenePath& path : paths)
        for (const ScenePoint& point : path.points)
            maximum = std::max(maximum, point.y);
    return maximum;
}
}  // namespace

TEST_CASE("an accented letter is its base letter plus the accent") {
    struct Case {
        const char* marked;
        const char* plain;
        std::size_t strokes;
    };
    for (const Case& one : {Case{"É", "E", 1}, Case{"Ü", "U", 2}, Case{"å", "a", 1},
                            Case{"č", "c", 1}, Case{"Ő", "O", 2}, Case{"ñ", "n", 1}}) {
        CAPTURE(one.marked);
        CHECK(strokes_besides(letter(one.marked), letter(one.plain)) == one.strokes);
        CHECK(strokes_besides(letter(one.plain), letter(one.marked)) == 0);
        CHECK(highest(letter(one.marked)) > highest(letter(one.plain)) + 0.5);
    }
    CHECK(strokes_besides(letter("ç"), letter("c")) == 1);
    CHECK(highest(letter("ç")) == highest(letter("c")));
}

TEST_CASE("every letter of Latin-1 and Latin Extended-A has its own glyph") {
    const auto box = letter("\xe4\xb8\xad");
    for (unsigned code = 0xc0; code < 0x180; ++code) {
        const std::string text{static_cast<char>(0xc0u | code >> 6),
                               static_cast<char>(0x80u | (code & 0x3fu))};
        CAPTURE(text);
        CHECK(missing_letters(text).empty());
        CHECK(letter(text) != box);
    }
}

TEST_CASE("a combining accent gives the same glyph as the precomposed letter") {
    CHECK(letter("e\xcc\x81") == letter("é"));
    CHECK(letter("A\xcc\x8a") == letter("Å"));
}

TEST_CASE("letters missing in the font are listed once each") {
    CHECK(missing_letters("Ж и Ж, ok") == "Ж и");
    CHECK(missing_letters("Hello, Wörld!\n").empty());
}
