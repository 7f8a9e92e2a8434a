#pragma once

#include "formats/slang/parameters.h"
#include "formats/slang/preset.h"

#include <set>

/// The controls for a preset's parameters.
struct SlangControls {
    std::vector<Heading> groups;        // in order, each name once
    std::vector<Parameter> parameters;  // without bindings
    Values fixed;  // values of headings, which may still be uniforms of a shader
    Diagnostics warnings;
};

/// Makes controls from parameters with unique ids, and repairs them:
/// - A parameter that cannot be changed is a heading: minimum = maximum, or an id that is not a
///   valid uniform name, or a step as large as the range. The last case needs a range of 0.01 or
///   less, a text without words, or a title ("[ TEXT ]", "== TEXT ==", "TEXT:"). A title with an
///   id in `read`, which shaders read, is not a heading.
/// - A heading starts the group of the following parameters, up to those of a file in another
///   folder. For consecutive headings the last title counts. Text after a title, and rows that
///   start like notes ("|| ...", "// ...", "INFO"), are help of the previous parameter, otherwise
///   of the next one.
/// - 0..1 in steps of 1 is a check box, or a list if its text names both values differently.
/// - At most 12 whole numbers are a list; those without a name in the text show the number.
/// - A minimum above the maximum is swapped, with a warning; a default outside widens the range.
/// A value in `values` is the default, because the preset is opened. The label omits the legend,
/// decoration and the words that start all labels of its group. The help is the full text if it
/// differs.
SlangControls slang_controls(const SlangParameters& parameters,
                             const std::map<std::string, SlangValue>& values,
                             const std::set<std::string>& read = {});
