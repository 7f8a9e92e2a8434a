#pragma once

#include "io/pictures/frame_names.h"
#include "io/video/film_file.h"
#include "io/video/frame_pipeline.h"
#include "model/picture/flash_log.h"

#include <cstdint>
#include <functional>

class Offline;

/// Which frames of a look's clock are written, numbered from 0: those before the first are drawn
/// too, as they leave their light behind.
struct ExportPart {
    std::int64_t first = 0;
    std::int64_t end = 0;  // behind the last

    std::int64_t count() const { return end - first; }
};

/// Frames from `start_seconds` on, for so many seconds, at least one.
ExportPart part_of(double start_seconds, double seconds, double fps);

/// What becomes of the frames.
struct ExportJob {
    ExportPart part;
    int pass = 0;
    double fps = 60.0;
    FramePipeline::Stages stages = {};
    FlashLog* flashes = nullptr;  // null: nobody asks
    /// So many frames are drawn; false: no more of them are wanted.
    std::function<bool(std::int64_t drawn)> go_on = {};
};

/// Pictures one by one, .png or .exr; a frame has the number that it has on the look's clock. PNGs
/// are all with alpha or all without.
FramePipeline::Stages sequence_stages(const FrameNames& names, std::int64_t first,
                                      bool keeps_alpha = false);
/// Pictures into a film, which lives as long.
FramePipeline::Stages film_stages(FilmFile& film);
/// Pictures as y4m into an open file of the system.
FramePipeline::Stages pipe_stages(int descriptor, Extent extent, const FilmRate& rate);

/// Draws from a fresh start and writes beside it; each file is whole or not there. Gives whether it
/// came to its end.
Result<bool> export_frames(Offline& offline, const ExportJob& job);

/// The sound of the part, as the signal has it; without samples where it has none.
FilmSound sound_of(const Offline& offline, const ExportPart& part, double fps);

/// The name of an output that is a pipe.
inline constexpr const char* export_pipe = "-";

/// Whether an output's name says that all frames become one film.
bool is_film_output(const std::string& output);
/// How long a film from `start_seconds` on is where nobody says so: as long as the sound that is
/// left, else 10 s. Fails where the sound is over before.
Result<double> usual_film_seconds(const Offline& offline, double start_seconds);
/// As export_frames, with the stages that the output's name asks for: a film, y4m into standard
/// output, or pictures. Warns of flashes where the pass is the picture.
Result<bool> export_to(const std::string& output, Offline& offline, ExportJob job,
                       Diagnostics& warnings);
