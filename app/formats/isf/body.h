#pragma once

#include <string>
#include <string_view>
#include <vector>

enum class IsfStage { vertex, fragment };

/// A name of the author's as the translated GLSL has it: another one where it became reserved.
std::string isf_word(std::string_view word);
/// The author's name behind such a word.
std::string_view isf_author_word(std::string_view word);

/// The GLSL of an ISF shader, written for GL 2.1 to 3.3 or GLSL ES, as that of 4.10: names that
/// went out of use and words that became reserved are replaced, `#version`, `#extension` and what
/// the program declares itself (`declared`) are blanked out. Every line stays where it was.
std::string isf_body(std::string_view code, IsfStage stage,
                     const std::vector<std::string>& declared);
