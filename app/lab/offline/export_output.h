#pragma once

#include "lab/offline/export.h"
#include "model/look/spec.h"

#include <memory>
#include <string>

/// The output name for standard output.
inline constexpr const char* export_pipe = "-";

/// Whether the output is standard output or a virtual camera: other programs read its frames, and
/// no file is written.
bool is_stream_output(const std::string& output);

/// Whether the output is a single film or stream.
bool is_film_output(const std::string& output);

/// Fails if a loop at this rate would lose frames: a GIF holds at most 50 per second.
Result<void> check_loop_rate(const std::string& output, double fps);

/// Whether the sound of a completed signal is drawn as XY, so that a lossy sound distorts the
/// figure.
bool is_drawn_as_xy(const Spec& signal);

/// The warning about a film whose lossy sound is drawn as XY; "": it is not.
std::string lossy_sound_warning(const FilmEncoding& encoding, const Spec& signal);

/// As export_frames(), with stages for the output name: a film, y4m to standard output, a
/// virtual camera, or pictures. Warns about flashes if the pass is the picture, and about lossy
/// sound.
Result<bool> export_to(const std::string& output, Offline& offline, ExportJob job,
                       Diagnostics& warnings);

/// As export_to() for a loop: the frame after the last one must equal the first within 1/255. If
/// not, the look has not settled, and the next period is written instead, four in all. The
/// pictures of a sequence are numbered from 0.
Result<bool> export_loop(const std::string& output, Offline& offline, const ExportJob& job,
                         Diagnostics& warnings);
