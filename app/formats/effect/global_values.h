#pragma once

#include "formats/glsl/modern_glsl.h"

#include <set>
#include <string>
#include <string_view>

/// What an entry function sets before it calls the author's main().
struct EntryValues {
    std::string settings = {};                     // statements that set uniforms
    std::set<std::string, std::less<>> late = {};  // names of uniforms and inputs
    std::string globals = {};  // statements that set variables whose values depend on them
};

/// Adds the new names of what a shader reads from the stage before.
void add_input_names(std::string_view shader, const WordChanges& words,
                     std::set<std::string, std::less<>>& names);

/// Takes away the initial values of global variables that depend on `late` names, also by way of
/// other variables, functions or macros. Those names are not constant, or are set only when the
/// entry function runs. Gives the statements that set the variables in that function, in order.
/// Lines stay in place.
std::string take_late_values(std::string& text, std::set<std::string, std::less<>> late);
