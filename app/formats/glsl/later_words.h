#pragma once

#include <span>
#include <string_view>

/// A word that was free for an author to use as a name until a version of GLSL, or a driver, took
/// it.
struct LaterWord {
    enum class Kind { keyword, type, function };

    /// Of what GLSL has reserved for later, and of what drivers have besides it.
    static constexpr int never = 1000;

    std::string_view word;
    int since = never;  // the desktop version that has it: 130, 400
    Kind kind = Kind::keyword;
};

/// All of them, in the order of their words.
std::span<const LaterWord> later_words();

/// Null where a word is not among them.
const LaterWord* find_later_word(std::string_view word);
