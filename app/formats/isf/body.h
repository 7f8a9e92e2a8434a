#pragma once

#include <string>
#include <string_view>
#include <vector>

enum class IsfStage { vertex, fragment };

/// The identifier in the translated GLSL for a name in the header. It differs if the name became
/// reserved or belongs to the language ("texture", "smooth").
std::string isf_declared_name(std::string_view name);
/// The author's name for such an identifier.
std::string_view isf_author_word(std::string_view word);

/// Converts the GLSL of an ISF shader, for GL 2.1 to 3.3 or GLSL ES, to 4.10, keeping line numbers.
/// Replaces removed names and words that became reserved. Also replaces `declared` names that
/// belong to the language, unless they are called. Blanks out `#version`, `#extension` and
/// declarations that the program adds itself (`declared`).
std::string isf_body(std::string_view code, IsfStage stage,
                     const std::vector<std::string>& declared);
