#pragma once

#include "model/devices/date.h"
#include "model/devices/hand.h"
#include "model/look/sound_texture.h"
#include "model/picture/source_raster.h"
#include "model/picture/source_spec.h"
#include "model/plan/beam.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

/// What a frame of a look is drawn for: its time, its beam, the mouse.
struct Frame {
    double time = 0;                                 // s, at the frame's end
    double time_delta = 0;                           // s
    std::int64_t number = 0;                         // from 1
    std::array<double, 2> mouse{};                   // px of the picture, from its bottom left
    double pixel_aspect = 1.0;                       // of the source: width to height of a pixel
    std::optional<SourceRaster> source_raster = {};  // none: the source has the picture's shape
    Press press;                                     // of its left button
    Keys keys;
    std::span<const BeamPoint> beam;
    std::optional<Fit> beam_fit = {};    // how -1..1 lies in the picture; none: as the look has it
    std::span<const BeamTint> tints;     // of the points; none where all are white
    const SoundTexels* sound = nullptr;  // null: silence
    Date date;
    bool is_first = false;        // no history, and no beam before this one
    double patience_seconds = 0;  // an accumulating pass repeats no longer; 0: without end
};
