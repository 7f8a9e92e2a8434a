#pragma once

#include "glsl/text/declarations.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// One key of an annotation and its words: `@range 0 1` or `@label "Beam strength"`.
struct Hint {
    std::string key;  // including '@'
    std::vector<std::string> words;
    Location at;

    bool has_same_text_as(const Hint& other) const;
};

using Hints = std::vector<Hint>;

/// Parses the hints in the comments of a uniform of `stage`. Text before the first '@' is ignored.
/// Errors: an unknown or repeated key, an unterminated string.
Hints parse_hints(const std::vector<Comment>& comments, const Stage& stage, Diagnostics& errors);

const Hint* find_hint(const Hints& hints, std::string_view key);

/// Merges another declaration's hints. Hints given in both must agree.
void merge_hints(Hints& hints, const Hints& others, const std::string& name, Diagnostics& errors);
