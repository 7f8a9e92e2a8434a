#pragma once

#include "formats/slang/parameters.h"
#include "formats/slang/preset.h"

#include <set>

/// What a person turns of a preset's parameters.
struct SlangControls {
    std::vector<Heading> groups;        // in order, each name once
    std::vector<Parameter> parameters;  // without bindings
    Values fixed;  // of what is a heading to a person and may still be a uniform to a shader
    Diagnostics warnings;
};

/// Makes controls of parameters with ids of their own, and repairs them:
/// - What cannot be turned is a heading: minimum = maximum; an id that no uniform could have; a
///   step as large as the range on "[ TEXT ]", "== TEXT ==", "TEXT:" (unless its id is in `read`,
///   as shaders read it) or a range of 0.01 or less. It is the group of the parameters that follow,
///   up to those of a file in another folder. Headings in a row: the last title counts. Prose
///   behind a title, and rows that begin as notes do
///   ("|| ...", "// ...", "INFO"), go to the help of the parameter before them, else after them.
/// - 0..1 in steps of 1 is a check box, or a list where its text names both sides otherwise.
/// - Whole numbers, at most 12, are a list; those that have no name in the text are numbers.
/// - A minimum above the maximum is swapped, with a warning; a default outside widens the range.
/// A value of `values` is the default, as the preset is what is opened. The label has neither
/// legend nor decoration nor the words that all of its group begin with; the text in full is the
/// help where it says more.
SlangControls slang_controls(const SlangParameters& parameters,
                             const std::map<std::string, SlangValue>& values,
                             const std::set<std::string>& read = {});
