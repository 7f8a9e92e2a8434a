#pragma once

#include "model/look/look.h"
#include "model/plan/beam.h"

#include <map>
#include <string>
#include <vector>

/// The user's changes to a pass for inspection, stored apart from the look.
struct PassOverride {
    std::optional<Format> format;
    std::optional<double> scale;   // of the viewport, for both sides
    std::optional<Filter> filter;  // for all inputs that read this pass

    bool operator==(const PassOverride&) const = default;
    bool is_empty() const { return !format && !scale && !filter; }
};

/// By name of the pass.
using PassOverrides = std::map<std::string, PassOverride>;

/// The look with overridden passes.
Look with_overrides(Look look, const PassOverrides& overrides);

/// The look with a picture that keeps light above 1: its last pass has floats instead of 8 bits.
Look with_kept_light(Look look);

/// The target of one pass.
struct PlannedTarget {
    Extent extent;
    Format format = Format::rgba16f;
    int slots = 1;  // stored pictures: the current one and previous ones that are still read
    bool mipmapped = false;  // some input reads mip levels
    // Index of the pass whose target it is drawn onto. It then has only a texel of transparent
    // black of its own, which its readers get. Extent and format are those of that target.
    std::optional<std::size_t> onto = std::nullopt;
    // Index in Plan::common of the picture for its newest output, which replaces one of its
    // `slots`. After the pass `last_reader`, others may draw there. If the target keeps previous
    // pictures, the newest one is then swapped with the oldest.
    std::optional<std::size_t> common = std::nullopt;
    std::size_t last_reader = 0;
    bool is_drawn_last = false;  // after all others; only later frames read it
    bool is_unused = false;      // neither drawn nor displayed: a single texel

    bool operator==(const PlannedTarget&) const = default;
};

/// A picture that several passes share.
struct CommonPicture {
    Extent extent;
    Format format = Format::rgba16f;
    bool mipmapped = false;

    bool operator==(const CommonPicture&) const = default;
};

/// Everything to allocate for drawing frames of a look at a size.
struct Plan {
    std::vector<PlannedTarget> targets;      // one per pass, in the same order
    int source_slots = 1;                    // source pictures kept
    std::vector<CommonPicture> common = {};  // each shared by several passes, one after the other

    bool operator==(const Plan&) const = default;
};

/// The conditions of a plan besides look, sizes and values.
struct PlanTerms {
    int largest_side = 16384;     // of a target, px
    std::vector<bool> seen = {};  // displayed passes; empty: all
    // Passes that are bypassed, frozen, left out, or not drawn in each frame; empty: none.
    std::vector<bool> kept = {};
    std::vector<bool> left_out = {};  // passes that need not exist; empty: none
    // No frame is partially redrawn, so a picture may be overwritten after its last read in the
    // frame.
    bool draws_once = false;
    // Inputs of each pass that its program reads; empty: all. Only used with draws_once.
    std::vector<std::vector<bool>> read = {};

    bool is_seen(std::size_t pass) const { return pass >= seen.size() || seen[pass]; }
    bool is_left_out(std::size_t pass) const { return pass < left_out.size() && left_out[pass]; }
    bool reads(std::size_t pass, std::size_t input) const;
    bool must_stand_alone(std::size_t pass) const;
};

/// Sizes, formats and lifetimes of the targets for a picture of `viewport` pixels. Fails if an
/// expression is invalid, or if a target would be empty or too large.
Result<Plan> plan_targets(const Look& look, Extent viewport, Extent source, const Values& values,
                          const PlanTerms& terms = {});

/// Pass indices in drawing order. Passes drawn onto another's target directly follow that pass. The
/// others are in the order of the look, except those drawn last.
std::vector<std::size_t> draw_order(const Plan& plan);

/// Whether another pass is drawn onto the target of this pass, or of one that it reads.
bool is_drawn_onto(const Look& look, const Plan& plan, std::size_t pass);

/// The smallest spot of a `segments` pass whose target has `extent`. The default is half a texel of
/// a target that the signal fills. Fails if an expression is invalid.
Result<BeamSpot> spot_of(const Look& look, const Pass& pass, Extent viewport, Extent extent,
                         const Values& values);

/// The size of the source of a pass's look: of the picture `source`, or in a stack of the previous
/// look's target.
Extent source_extent_of(const Look& look, const Pass& pass, const Plan& plan, Extent source);

/// Bytes of all targets, or of a target's own pictures.
std::size_t memory_of(const Plan& plan);
std::size_t memory_of(const PlannedTarget& target);

/// What to draw to show the current frame with other values.
struct Redraw {
    std::vector<bool> passes;   // affected by the change within a frame
    bool needs_replay = false;  // earlier frames that this one depends on are affected too
};

/// The passes affected by `changed` passes within a frame, including these.
std::vector<bool> dependents_of(const Look& look, std::vector<bool> changed);

/// For a paused picture: what a change of these passes requires, one flag per pass.
Redraw redraw_of(const Look& look, std::vector<bool> changed);
/// As redraw_of, for a change of these parameters.
Redraw redraw_after(const Look& look, const std::vector<std::string>& parameters);

/// Passes that the picture of `pass` depends on, including itself, over all frames.
std::vector<bool> dependencies_of(const Look& look, int pass);

/// Passes that later frames depend on: those to draw in a frame that is not displayed.
std::vector<bool> feedback_passes(const Look& look);
