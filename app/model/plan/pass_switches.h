#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <set>
#include <string>
#include <vector>

/// What a person may switch about a pass, to find out what it does.
enum class PassSwitch {
    bypass,  // hands on what it reads
    freeze,  // keeps what it drew last
    solo,    // is seen in the place of the picture
    stop,    // the same, and later passes are not drawn
};

/// The passes that are switched, by their names. Part of no preset.
struct PassSwitches {
    std::set<std::string> bypassed;
    std::set<std::string> frozen;
    std::string solo;  // "": none
    std::string last;  // that is drawn; "": all are

    bool operator==(const PassSwitches&) const = default;
    bool is_empty() const { return *this == PassSwitches{}; }
    bool has(PassSwitch which, const std::string& pass) const;
};

/// With one of them turned on, or off where it is on. At most one pass is seen alone or stopped at.
/// Fails with the reason where it cannot be.
Result<PassSwitches> switched(const Look& look, PassSwitches switches, PassSwitch which,
                              const std::string& pass);

/// Those of passes that the look has.
PassSwitches known_switches(const Look& look, PassSwitches switches);

/// What a bypassed pass hands on: what its first input reads, its own past left out, and an image
/// only where there is nothing else. Null: nothing.
const Input* handed_on(const Pass& pass);

/// The pass that is seen as the picture.
std::size_t picture_pass(const Look& look, const PassSwitches& switches);

/// What is done about a pass in every frame.
enum class PassRun {
    drawn,
    bypassed,  // its target gets what handed_on() reads
    frozen,    // keeps its last picture, and was always so for who reads its past
    left_out,  // the same, but it is forgotten with the rest of the past
};

/// One a pass; empty where all are drawn.
std::vector<PassRun> runs_of(const Look& look, const PassSwitches& switches);
