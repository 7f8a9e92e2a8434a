#pragma once

#include "glsl/text/declarations.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// One key of an annotation and its words: `@range 0 1` or `@label "Beam strength"`.
struct Hint {
    std::string key;  // with its '@'
    std::vector<std::string> words;
    Location at;

    bool says_the_same_as(const Hint& other) const;
};

using Hints = std::vector<Hint>;

/// Reads the hints in the comments behind a uniform of `stage`; what stands before the first '@' is
/// for people. Errors: an unknown key, one given twice, a string that does not end.
Hints parse_hints(const std::vector<Comment>& comments, const Stage& stage, Diagnostics& errors);

const Hint* find_hint(const Hints& hints, std::string_view key);

/// Adds another declaration's hints to those of the first. What both say must agree.
void merge_hints(Hints& hints, const Hints& others, const std::string& name, Diagnostics& errors);
