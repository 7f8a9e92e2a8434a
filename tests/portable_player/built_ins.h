#pragma once

#include "portable_player/pictures.h"

#include <vector>

/// What the built-in uniforms of a pass depend on.
struct PassState {
    int number = 1;  // of the frame
    int frame_modulo = 0;
    int samples = 0;
    Size target{};
    Size view{};
    Size source{};
    Size of{};  // of the input that the uniform names
    Raster source_lines{};
    Raster source_columns{};
    double source_pixel_aspect = 1.0;
    bool is_top_first = false;
    bool is_drawn_onto = false;
};

/// The numbers of a built-in value, by columns for a matrix. Empty for `view` and `camera`.
std::vector<double> numbers_of(const std::string& value, const PassState& state);

/// The lines or columns of a source that fills the picture.
Raster own_raster(int count);
