#pragma once

#include "model/look/extent.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Parameter names and values, as `--set` takes them.
using GoldenSettings = std::vector<std::pair<std::string, std::string>>;

/// A look, and how its golden pictures are drawn.
struct GoldenLook {
    std::string id;
    std::vector<int> frames{1, 16, 64};  // side by side in a picture
    Extent cell{160, 90};                // px of one frame, in the sweep of the parameters
    Extent preset_cell{256, 144};        // px of one frame of a preset
    GoldenSettings always = {};          // in the sweep: settings that reduce noise
    std::map<std::string, GoldenSettings> companions =
        {};  // by parameter: settings that it needs to have an effect
    std::map<std::string, std::array<std::string, 2>> ends =
        {};  // by parameter: values instead of the ends of its range
    std::map<std::string, std::string> signals =
        {};  // by parameter: a signal instead of the look's own
    std::map<std::string, std::string> sources =
        {};                        // parameters that it has only with a picture: a source for each
    bool draws_subframes = false;  // each is one of the frames
    std::size_t fewest_presets = 4;
    std::set<std::string> faster = {};  // presets that look the same as another one and cost less
    std::string signal = {};            // in the sweep, for a look on a signal; "": the look's own
    std::string source = {};            // the same for a look on a picture
};

/// Draws the look with each parameter at its low and its high end, and compares with the pictures
/// in tests/golden/LOOK/. One of the ends must change the picture. AFTERGLOW_UPDATE_GOLDEN=1
/// rewrites them: look at each picture before you commit it.
void check_parameters(const GoldenLook& look);

/// The same with each preset; no two presets may look the same.
void check_presets(const GoldenLook& look);
