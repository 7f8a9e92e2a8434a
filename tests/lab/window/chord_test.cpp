#include "lab/window/chord.h"

#include <doctest/doctest.h>

#include <string>

TEST_CASE("a chord reads back from its text") {
    for (const char* text : {"A", "Ctrl+S", "Ctrl+Shift+PageDown", "F1", "Shift+F12", "Space",
                             "Ctrl+=", "-", "Ctrl++", "Backspace", ".", "Home"}) {
        CAPTURE(text);
        const auto chord = parse_chord(text);
        REQUIRE(chord.has_value());
        CHECK(chord_text(*chord) == text);
    }
    CHECK(parse_chord(" ctrl+shift+s ") == Chord{'S', true, true});
    CHECK(parse_chord("") == Chord{});
    CHECK(chord_text({}).empty());
}

TEST_CASE("a text that is not a chord is refused") {
    for (const char* text : {"F13", "F0", "Fx", "Alt+A", "Shift+Ctrl+A", "Ctrl+", "AB", "Ctrl", "ä",
                             "F1 F2", "\x01"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_chord(text).has_value());
    }
}

TEST_CASE("reserved keys and modifiers cannot be assigned") {
    constexpr int escape = 256;
    constexpr int tab = 258;
    constexpr int f10 = 299;
    constexpr int left_shift = 340;
    for (const int key : {0, escape, tab, f10, left_shift})
        CHECK_FALSE(is_assignable({key}));
    CHECK(is_assignable({'A'}));
    CHECK(is_assignable({' ', true}));
    CHECK(is_assignable(*parse_chord("F9")));
}
