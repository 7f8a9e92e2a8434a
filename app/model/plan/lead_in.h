#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>

/// The frames to draw before a frame of a film, from an empty history, so that it looks as if all
/// earlier frames had been drawn.
struct LeadIn {
    std::optional<std::int64_t> frames = std::nullopt;  // nullopt: all earlier frames
    std::string reason = {};                            // why all; "" if `frames` is set

    bool operator==(const LeadIn&) const = default;
};

/// The lead-in at these values. What remains of the history is less than half an 8-bit step: after
/// t seconds, the peak's light L gives L exp(-t / time constant), and sRGB encoding multiplies weak
/// light by 12.92 (IEC 61966-2-1).
/// `subframes`: drawn frames per source frame, see PreparedLook::draws_subframes. Earlier pictures
/// of the source are source frames.
/// `moving`: parameters that change over time. If the look's fading depends on one, all frames are
/// needed. So they are if nothing is known about a history without end, or if a pass accumulates.
LeadIn lead_in_of(const Look& look, const Values& values, double fps, int subframes = 1,
                  const std::set<std::string>& moving = {});

/// Errors in the look's expressions for its fading. Values that are not finite are none.
Diagnostics check_fading(const Look& look);
