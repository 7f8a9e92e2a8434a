#pragma once

#include <cstddef>
#include <vector>

/// The progress of a frame: by pass, by draw of a pass, by band of a draw.
struct FrameProgress {
    std::vector<bool> passes;  // of the look: whether they are drawn
    bool is_whole = false;     // all passes
    bool is_again = false;     // redraws a frame: the history does not advance
    std::size_t pass = 0;      // index in the drawing order
    int first_draw = 0;        // of the pass
    int draw = 0;
    int draws = 0;  // end of the draws
    int row = 0;    // of the draw
    int draw_calls = 0;
    bool has_begun_pass = false;
    double pass_seconds = 0.0;  // time of its draws so far
};
