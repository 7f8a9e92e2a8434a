#pragma once

#include "model/devices/date.h"
#include "model/devices/input_state.h"
#include "model/look/sound_texture.h"
#include "model/look/subframe.h"
#include "model/picture/hdr.h"
#include "model/picture/source_raster.h"
#include "model/picture/source_spec.h"
#include "model/plan/beam.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

/// The state that a frame of a look is drawn for: its time, beam, sound, mouse and keys.
struct Frame {
    double time = 0;          // s, at the frame's end
    double time_delta = 0;    // s
    std::int64_t number = 0;  // from 1
    Subframe subframe = {};
    std::int64_t source_number = 0;  // of its source frame, from 1; 0: from number and subframe
    bool is_whole = false;           // shaders draw the whole source frame instead of the sub-frame
    std::optional<HdrLight> hdr = {};                // of the display; nullopt: no HDR
    std::array<double, 2> mouse{};                   // px of the picture, from its bottom left
    double pixel_aspect = 1.0;                       // of the source: width to height of a pixel
    std::optional<SourceRaster> source_raster = {};  // nullopt: the source fills the picture
    Press press;                                     // of the left mouse button
    Keys keys;
    std::span<const BeamPoint> beam;
    std::optional<Fit> beam_fit = {};    // maps -1..1 to the picture; nullopt: as in the look
    std::span<const BeamTint> tints;     // one per point; empty: all are white
    const SoundTexels* sound = nullptr;  // null: silence
    Date date;
    bool is_first = false;             // no history and no previous beam
    double sample_budget_seconds = 0;  // limit for the samples of an accumulating pass; 0: none
};

/// The sub-frame that shaders draw.
inline Subframe shown_subframe(const Frame& frame) {
    return frame.is_whole ? Subframe{} : frame.subframe;
}

/// The frame as a pass that is drawn once per source frame gets it: it lasts as long as all of its
/// sub-frames, which are assumed to be equally long.
Frame source_frame_of(const Frame& frame);
