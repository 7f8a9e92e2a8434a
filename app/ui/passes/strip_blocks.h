#pragma once

#include "ui/frame/scene.h"
#include "ui/widgets/elided_name.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// A pass in the strip and its current values.
struct StripPass {
    std::size_t index = 0;
    const Pass& pass;
    const PlannedTarget& target;
    double milliseconds = 0.0;
    const TargetLevel* gain = nullptr;      // null: not measured yet
    std::optional<PassChange> change = {};  // by the previewed step
    bool is_chosen = false;
    std::string state = {};  // switch state; "": unchanged
};

/// The text below a picture of the strip.
struct StripText {
    ElidedName name;
    std::string info;
    double milliseconds = 0.0;
    double longest = 0.0;  // ms, of one pass
    const TargetLevel* gain = nullptr;
    std::optional<PassChange> change = {};
    bool is_chosen = false;
};

/// A pass, or the levels of a pyramid side by side as one picture.
struct StripBlock {
    std::span<const StripPass> passes;
    StripText text;
    std::string state;  // switch state; "": unchanged
    float width = 0.0f;
    bool is_narrow = false;  // shows the time instead of size and format

    bool is_pass() const { return passes.size() == 1; }
    float width_of_one() const { return width / static_cast<float>(passes.size()); }
};

/// The passes of the strip: all that are not idle, switched ones and the inspected one.
std::vector<StripPass> present_passes(const Scene& scene);

/// The blocks from left to right in a strip of width `room`.
std::vector<StripBlock> arrange_strip(std::span<const StripPass> passes, float room,
                                      const Scene& scene);

/// The gap between two blocks of the same look.
float strip_gap();
