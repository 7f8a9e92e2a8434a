#pragma once

#include "base/work.h"
#include "lab/document/document.h"
#include "lab/window/window_state.h"
#include "model/picture/fall.h"

#include <string>
#include <vector>

class Offline;

/// Where a flash is fired, and how its fall is watched.
struct ImpulseQuestion {
    Pin place;
    double fps = 60.0;
    double seconds = 2.0;
};

/// What came of a flash in a pass, at the texel there.
struct PassImpulse {
    std::string pass;
    int channel = 0;            // 0 red, 1 green, 2 blue: the brightest
    std::vector<double> light;  // above what was there before; of each frame, linear
    Fall fall;                  // with times from the end of the flash's frame
};

/// A flash of one frame, as it falls in every pass.
struct ImpulseResponse {
    Extent size;
    ImpulseQuestion question;
    std::vector<double> seconds;  // ends of the frames; 0: of the flash's
    std::vector<PassImpulse> passes;
};

/// Fires a flash in the dark: the beam stands there for one frame with a 256th of the charge that
/// it has in a sixtieth of a second; a source is white for one frame. `offline` has drawn nothing
/// yet. Fails where nothing drives the look, and when it is cancelled.
Result<ImpulseResponse> fire_impulse(Offline& offline, Extent size, const ImpulseQuestion& question,
                                     Work& work);

/// The same with a GL context of its own, at the size that is drawn for a picture (at most 360
/// lines).
Result<ImpulseResponse> fire_impulse(Document document, Extent picture,
                                     const ImpulseQuestion& question, Work& work);
