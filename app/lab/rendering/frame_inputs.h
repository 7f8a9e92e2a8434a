#pragma once

#include "graph/programs/frame.h"
#include "lab/playback/player.h"

#include <memory>
#include <optional>

/// What the frames of a look get besides beam and time.
struct FrameInputs {
    InputState input_state = {};
    double pixel_aspect = 1.0;  // of the source: width / height of a pixel
    // The position of the source's lines in the picture; nullopt: they fill it.
    std::optional<SourceRaster> source_raster = {};
    std::optional<Fit> beam_fit = {};  // of the beam to the picture; nullopt: the look's
    std::shared_ptr<const SoundTexels> sound = {};  // shared with the player; null: silence
    std::optional<Date> date = {};                  // nullopt: that of offline renders
    // The time per frame for samples of accumulating passes; 0: no limit. The rest is left to the
    // next frames.
    double sample_budget_seconds = 0.0;
    bool shows_whole = false;          // whole source frames, also where sub-frames are drawn
    std::optional<HdrLight> hdr = {};  // of the display; nullopt: no HDR
    bool is_black = false;  // the picture is shown and exported as black; its passes are drawn
};

/// `inputs` and `beam` must outlive the result.
Frame frame_of(const FrameInputs& inputs, const PlayedFrame& played, const Beam& beam);
