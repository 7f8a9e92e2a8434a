#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <set>
#include <string>
#include <vector>

/// Debugging switches of a pass.
enum class PassSwitch {
    bypass,  // passes its first input through
    freeze,  // keeps its last picture
    solo,    // is displayed instead of the picture
    stop,    // likewise, and later passes are not drawn
};

/// The switched passes, by name. Not part of presets.
struct PassSwitches {
    std::set<std::string> bypassed;
    std::set<std::string> frozen;
    std::string solo;  // "": none
    std::string last;  // the last pass that is drawn; "": all are drawn

    bool operator==(const PassSwitches&) const = default;
    bool is_empty() const { return *this == PassSwitches{}; }
    bool has(PassSwitch which, const std::string& pass) const;
};

/// Toggles a switch of a pass. At most one pass has solo or stop. Fails if the switch is not
/// possible.
Result<PassSwitches> switched(const Look& look, PassSwitches switches, PassSwitch which,
                              const std::string& pass);

/// The switches of passes that exist in the look.
PassSwitches known_switches(const Look& look, PassSwitches switches);

/// The input that a bypassed pass passes through: the first input that isn't its own output;
/// otherwise an image. Null without such an input.
const Input* passed_input(const Pass& pass);

/// The pass that is displayed as the picture.
std::size_t picture_pass(const Look& look, const PassSwitches& switches);

/// How a pass is handled in each frame.
enum class PassRun {
    drawn,
    bypassed,  // its target gets the input of passed_input()
    frozen,    // keeps its last picture, which is also its whole history
    left_out,  // likewise, but discarded with its history
};

/// One per pass; empty if all are drawn.
std::vector<PassRun> runs_of(const Look& look, const PassSwitches& switches);
