#pragma once

#include <optional>
#include <string>
#include <string_view>

/// A key with its modifiers.
struct Chord {
    int key = 0;  // key code of gpu::KeyEvent; 0: no key
    bool control = false;
    bool shift = false;

    bool operator==(const Chord&) const = default;
};

/// "Ctrl+Shift+S"; "": no key.
std::string chord_text(const Chord& chord);

/// The chord of a text, in any case; "" is no key. nullopt: not a chord.
std::optional<Chord> parse_chord(std::string_view text);

/// Whether the user may assign the chord to an action. Escape, Tab and F10 are reserved.
bool is_assignable(const Chord& chord);
