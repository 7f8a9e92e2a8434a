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

/// A look and how its pictures are kept.
struct GoldenLook {
    std::string id;
    std::vector<int> frames{1, 16, 64};  // side by side in a picture
    Extent cell{160, 90};                // px of one frame, in the sweep of the parameters
    Extent preset_cell{256, 144};        // px of one frame of a preset
    GoldenSettings always = {};          // in the sweep: what quietens noise
    std::map<std::string, GoldenSettings> companions =
        {};  // what a parameter needs to show anything
    std::map<std::string, std::array<std::string, 2>> ends =
        {};  // other values than the ends of a parameter's range
    std::map<std::string, std::string> signals =
        {};  // by parameter: another signal than the look's own
    std::size_t fewest_presets = 4;
    std::set<std::string> faster = {};  // presets that look as another one and cost less
    std::string signal = {};            // in the sweep, for a look on a signal; "": the look's own
    std::string source = {};            // the same for a look on a picture
};

/// Draws the look with each parameter at its low and its high end and compares with the pictures
/// kept in tests/golden/LOOK/. One of the ends must change the picture. AFTERGLOW_UPDATE_GOLDEN=1
/// writes them anew: look at each before it is kept.
void check_parameters(const GoldenLook& look);

/// The same with each preset; no two may look the same.
void check_presets(const GoldenLook& look);
