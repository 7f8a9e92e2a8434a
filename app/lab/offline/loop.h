#pragma once

#include "lab/document/document.h"
#include "lab/offline/export.h"
#include "model/tuning/repetition.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class PlayedSignal;

/// How the picture of a document repeats, as far as its signal and its LFOs tell. What the shaders
/// and a moving source do is not known.
Repetition repetition_of(const Document& document, const PlayedSignal& signal);

/// What a loop is searched for.
struct LoopSearch {
    Extent extent;  // of the picture
    double fps = 60.0;
    double seconds = 0.0;  // one period, as the user says; 0: find it
    /// Reports the number of drawn frames and of those expected; false: cancel.
    std::function<bool(std::int64_t drawn, std::int64_t of)> should_continue = {};
};

/// The number of frames of one period of `seconds`. Fails if it is not whole, and names the frame
/// rates that fit.
Result<std::int64_t> loop_frames(const Fraction& seconds, double fps);

/// The frames of one period, after the look has settled. Draws a small picture of the document
/// until it repeats. nullopt: cancelled. Fails if it never repeats, if the period is not a whole
/// number of frames, or if none is found in the first 120 s of the picture.
Result<std::optional<ExportPart>> find_loop(const Document& document, const LoopSearch& search);

/// Finds the smallest period in a series of pictures.
class PeriodFinder {
public:
    /// A period is a multiple of `step` frames, up to `longest`. It is found when the pictures have
    /// repeated for a whole period and at least `least` frames.
    PeriodFinder(std::int64_t step, std::int64_t longest, std::int64_t least)
        : m_step(step), m_longest(longest), m_least(least) {}

    /// Adds the next picture of equal size. Returns the period in frames, once it is found.
    std::optional<std::int64_t> add(std::vector<std::uint8_t> picture);

private:
    bool is_same(std::int64_t frames_ago) const;

    std::int64_t m_step;
    std::int64_t m_longest;
    std::int64_t m_least;
    std::vector<std::vector<std::uint8_t>> m_pictures;  // of the last frames, a ring
    std::vector<std::int64_t> m_runs;  // for each period: since when the pictures repeat, in frames
    std::int64_t m_count = 0;
};
