#pragma once

#include <span>
#include <string_view>

/// A word that was a valid identifier until a version of GLSL, or a driver, reserved it.
struct ReservedWord {
    enum class Kind { keyword, type, function };

    /// Reserved for future use in GLSL, or reserved by drivers.
    static constexpr int never = 1000;

    std::string_view word;
    int since = never;  // first desktop version: 130, 400
    Kind kind = Kind::keyword;
};

/// All of them, in alphabetical order.
std::span<const ReservedWord> reserved_words();

/// Null if the word is not one of them.
const ReservedWord* find_reserved_word(std::string_view word);
