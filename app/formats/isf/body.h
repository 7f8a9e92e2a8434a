#pragma once

#include <string>
#include <string_view>
#include <vector>

enum class IsfStage { vertex, fragment };

/// A name that the header declares as the translated GLSL has it: another one where it became
/// reserved, or is what the language calls something of its own ("texture", "smooth").
std::string isf_declared_word(std::string_view name);
/// The author's name behind such a word.
std::string_view isf_author_word(std::string_view word);

/// The GLSL of an ISF shader, written for GL 2.1 to 3.3 or GLSL ES, as that of 4.10: names that
/// went out of use and words that became reserved are replaced, as are `declared` ones that the
/// language has for itself where they are not called; `#version`, `#extension` and declarations of
/// what the program declares itself (`declared`) are blanked out. Every line stays where it was.
std::string isf_body(std::string_view code, IsfStage stage,
                     const std::vector<std::string>& declared);
