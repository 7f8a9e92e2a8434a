#pragma once

#include "formats/glsl/modern_glsl.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// What a uniform becomes if it is a constant.
struct EffectConstant {
    std::string type;
    std::string value;
};

/// How the declarations of a shader change for another program. All other text stays.
struct EffectTextRules {
    /// Uniforms that are declared elsewhere: their declarations become comments.
    std::set<std::string, std::less<>> declared = {};
    /// Members of other uniforms, which are structs, as arguments. "": no value. Uniforms without
    /// an entry keep their own value, or are 0.
    std::map<std::string, std::string, std::less<>> values = {};
    /// Uniforms that become constants at the same place.
    std::map<std::string, EffectConstant, std::less<>> constants = {};
    std::string input = {};   // the qualifiers of inputs; "": they become variables
    std::string output = {};  // the same of outputs
    WordChanges words = {};   // renamed words of the code
};

/// The text with these declarations. `#version`, `#extension`, `#line` and `#pragma once` are
/// blanked out. Lines stay in place.
std::string effect_text(std::string_view text, const EffectTextRules& rules);

/// The new name of a word.
std::string renamed_word(const WordChanges& words, const std::string& word);

/// New names for what a text declares under the name of a function of GLSL, which not all compilers
/// allow, or with the prefix "afterglow_", which exports use.
WordChanges renamed_built_ins(std::string_view text);

/// The `#extension` lines of a text, each once.
std::vector<std::string> extension_lines(std::string_view text);
