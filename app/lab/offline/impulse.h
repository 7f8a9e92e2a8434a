#pragma once

#include "base/job_progress.h"
#include "lab/document/document.h"
#include "lab/window/probes.h"
#include "model/picture/decay_curve.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class Offline;

/// The position of an impulse and its measurement.
struct ImpulseRequest {
    Pin pin;
    double fps = 60.0;
    double seconds = 2.0;
    // The only pass to draw and measure, which reads its own earlier frames. nullopt: all.
    std::optional<std::size_t> pass = {};
};

/// The response of a pass at the texel of the impulse.
struct PassImpulse {
    std::string pass;
    int channel = 0;                            // 0 red, 1 green, 2 blue: the brightest
    std::vector<double> light;                  // above the background; per frame, linear
    std::vector<std::array<double, 3>> colors;  // the same in all channels
    DecayCurve decay;                           // times from the end of the impulse's frame
};

/// The response of all passes to an impulse of one frame.
struct ImpulseResponse {
    Extent size;
    ImpulseRequest request;
    std::vector<double> seconds;  // end times of the frames; 0: end of the impulse's frame
    std::vector<PassImpulse> passes;
};

/// Draws an impulse in the dark. For a signal, the beam is at this position for one frame, with
/// 1/256 of its charge in 1/60 s. A source is white for one frame. `offline` must be in its initial
/// state. Fails if the look uses neither a signal nor a picture, and when cancelled.
Result<ImpulseResponse> fire_impulse(Offline& offline, Extent size, const ImpulseRequest& request,
                                     JobProgress& work);

/// The same in its own GL context, at size_to_compare() of the picture (at most 360 lines).
Result<ImpulseResponse> fire_impulse(Document document, Extent picture,
                                     const ImpulseRequest& request, JobProgress& work);
