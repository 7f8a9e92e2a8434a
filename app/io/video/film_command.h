#pragma once

#include "io/video/film_codec.h"
#include "model/picture/frame_rate_fraction.h"

#include <string>
#include <vector>

/// What ffmpeg gets and writes: raw pictures on its standard input, and samples as 32-bit floats on
/// ChildProcess::second_input.
struct FilmStreams {
    Extent extent;
    FrameRateFraction rate;  // of the pictures that it gets
    int sound_rate = 0;      // samples per second; 0: no sound
};

/// The ffmpeg command that writes a film to ChildProcess::given_output.
std::vector<std::string> film_command(const FilmEncoding& encoding, const FilmStreams& streams);
