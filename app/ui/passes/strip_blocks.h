#pragma once

#include "ui/frame/scene.h"
#include "ui/widgets/told_apart.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// A pass in the strip, and what is known of it now.
struct StripPass {
    std::size_t index = 0;
    const Pass& pass;
    const PlannedTarget& target;
    double milliseconds = 0.0;
    const Gain* gain = nullptr;             // null: not measured yet
    std::optional<PassChange> change = {};  // by the step that somebody asks about
    bool is_chosen = false;
    std::string state = {};  // what is switched about it; "": nothing
};

/// What is said below a picture of the strip.
struct StripWords {
    ToldName name;
    std::string facts;
    double milliseconds = 0.0;
    double longest = 0.0;  // ms, of one pass
    const Gain* gain = nullptr;
    std::optional<PassChange> change = {};
    bool is_chosen = false;
};

/// A pass, or the levels of a pyramid side by side as one picture.
struct StripBlock {
    std::span<const StripPass> passes;
    StripWords words;
    std::string state;  // what is switched; "": nothing
    float width = 0.0f;
    bool is_narrow = false;  // the time stands in the place of size and format

    bool is_pass() const { return passes.size() == 1; }
    float width_of_one() const { return width / static_cast<float>(passes.size()); }
};

/// Passes that the picture is not without at present, switched ones and the one that is looked
/// into.
std::vector<StripPass> present_passes(const Scene& scene);

/// From the left to the right of a strip that has `room`.
std::vector<StripBlock> arrange_strip(std::span<const StripPass> passes, float room,
                                      const Scene& scene);

/// From one block to the next of the same look.
float strip_gap();
