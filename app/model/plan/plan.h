#pragma once

#include "model/look/look.h"
#include "model/plan/beam.h"

#include <map>
#include <string>
#include <vector>

/// What a person changed about a pass while looking into it; kept apart from the look.
struct PassOverride {
    std::optional<Format> format;
    std::optional<double> scale;   // of the viewport, both sides
    std::optional<Filter> filter;  // of every input that reads this pass

    bool operator==(const PassOverride&) const = default;
    bool is_empty() const { return !format && !scale && !filter; }
};

/// By the pass's name.
using PassOverrides = std::map<std::string, PassOverride>;

/// The look with its passes as a person overrode them.
Look with_overrides(Look look, const PassOverrides& overrides);

/// The target of one pass.
struct PlannedTarget {
    Extent extent;
    Format format = Format::rgba16f;
    int slots = 1;           // pictures kept: the current one and those that some input still reads
    bool mipmapped = false;  // some input reads its smaller levels
    // The place of the pass onto whose target it is drawn: then it has none of its own but a texel
    // of transparent black, which whatever reads it gets, and extent and format are that target's.
    std::optional<std::size_t> onto = std::nullopt;
    // The place in Plan::common of what its newest picture is drawn into: one of `slots` is not its
    // own then. Behind the pass `held_until` others may draw there; where the target keeps former
    // pictures, the newest one changes places with the oldest at that time.
    std::optional<std::size_t> common = std::nullopt;
    std::size_t held_until = 0;
    bool is_drawn_last = false;  // behind all others, as only later frames read it
    bool is_unused = false;      // never drawn nor looked at: it has but a texel

    bool operator==(const PlannedTarget&) const = default;
};

/// A picture that is no pass's own.
struct CommonPicture {
    Extent extent;
    Format format = Format::rgba16f;
    bool mipmapped = false;

    bool operator==(const CommonPicture&) const = default;
};

/// What must be allocated to draw a frame of a look at a size.
struct Plan {
    std::vector<PlannedTarget> targets;      // one a pass, in the same order
    int source_slots = 1;                    // source pictures kept
    std::vector<CommonPicture> common = {};  // that several passes draw into, one after the other

    bool operator==(const Plan&) const = default;
};

/// What a plan depends on besides look, sizes and values.
struct PlanTerms {
    int largest_side = 16384;         // of a target, px
    std::vector<bool> seen = {};      // passes whose own pictures somebody looks at; empty: all
    std::vector<bool> kept = {};      // passes that draw nothing of their own; empty: none
    std::vector<bool> left_out = {};  // those of them that are not even to be there
    // No frame is ever drawn again in part, so that a picture may be drawn over as soon as the last
    // of its frame has read it.
    bool draws_once = false;
    // Of each pass's inputs those that its program reads; empty: all. Counts with draws_once.
    std::vector<std::vector<bool>> read = {};

    bool is_seen(std::size_t pass) const { return pass >= seen.size() || seen[pass]; }
    bool is_left_out(std::size_t pass) const { return pass < left_out.size() && left_out[pass]; }
    bool reads(std::size_t pass, std::size_t input) const;
    bool must_stand_alone(std::size_t pass) const;
};

/// Sizes, formats and lifetimes of the targets for a picture of `viewport` pixels.
/// Fails where an expression cannot be read or a target would be empty or too large.
Result<Plan> plan_targets(const Look& look, Extent viewport, Extent source, const Values& values,
                          const PlanTerms& terms = {});

/// Passes by place, in the order in which they are drawn: those that are drawn onto another's
/// target come right behind that one, the rest as the look has them, but for those drawn last.
std::vector<std::size_t> draw_order(const Plan& plan);

/// Whether something is drawn onto the target of the pass, or onto one that it reads.
bool meets_drawn_onto(const Look& look, const Plan& plan, std::size_t pass);

/// The smallest spot of a pass of segments whose target has `extent`; where its look does not say
/// so, half a texel of a target that the signal fills. Fails where an expression cannot be read.
Result<BeamSpot> spot_of(const Look& look, const Pass& pass, Extent viewport, Extent extent,
                         const Values& values);

/// The size of what a pass's look reads as the source: of the picture `source`, or in a stack of
/// the target of the look before.
Extent source_extent_of(const Look& look, const Pass& pass, const Plan& plan, Extent source);

/// Bytes that the targets hold, all of them or what is a target's own.
std::size_t memory_of(const Plan& plan);
std::size_t memory_of(const PlannedTarget& target);

/// What drawing the present frame again with other values takes.
struct Redraw {
    std::vector<bool> passes;   // those that the change reaches within a frame
    bool needs_replay = false;  // it also reaches earlier frames that this one is made of
};

/// The passes that `changed` ones reach within a frame, these included.
std::vector<bool> reached_from(const Look& look, std::vector<bool> changed);

/// For a paused picture: what shows a change of these passes, one flag each.
Redraw redraw_of(const Look& look, std::vector<bool> changed);
/// The same for a change of these parameters.
Redraw redraw_after(const Look& look, const std::vector<std::string>& parameters);

/// Passes on which the picture of `pass` depends, itself included; over all frames.
std::vector<bool> needed_for(const Look& look, int pass);

/// Passes that later frames are made of: what must be drawn of a frame that nobody looks at.
std::vector<bool> carried_passes(const Look& look);
