#pragma once

#include <cstddef>
#include <vector>

/// How far the drawing of a frame has come: pass after pass, draw after draw of a pass, band after
/// band of a draw.
struct FrameWork {
    std::vector<bool> passes;  // of the look; those that are drawn
    bool is_again = false;     // the frame was drawn before: history does not move
    std::size_t pass = 0;      // place in the order of drawing
    int first_draw = 0;        // of the pass
    int draw = 0;
    int draws = 0;  // up to this one
    int row = 0;    // of the draw
    int draw_calls = 0;
    bool has_begun_pass = false;
    double pass_seconds = 0.0;  // that its draws took so far
};
