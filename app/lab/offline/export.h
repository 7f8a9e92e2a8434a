#pragma once

#include "io/pictures/frame_names.h"
#include "io/video/film_file.h"
#include "io/video/frame_bytes.h"
#include "io/video/frame_pipeline.h"
#include "io/video/hdr_frame.h"
#include "io/virtual_camera/virtual_camera.h"
#include "model/picture/flash_log.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

class Offline;

/// The range of frames to write, numbered from 0. Earlier frames are also drawn, because they
/// affect later ones.
struct ExportPart {
    std::int64_t first = 0;
    std::int64_t end = 0;  // after the last frame

    std::int64_t count() const { return end - first; }
};

/// The frames from `start_seconds` on for `seconds`, at least one.
ExportPart part_of(double start_seconds, double seconds, double fps);

/// An export: which frames of which pass, and how they are written.
struct ExportJob {
    ExportPart part;
    int pass = 0;
    double fps = 60.0;
    bool loops = false;  // the pictures are numbered from 0
    FilmChoice film = {};
    FramePipeline::Stages stages = {};
    FlashLog* flashes = nullptr;  // null: not counted
    int subframes = 1;            // whose mean the flashes count as one frame
    // Pictures that exist, which are read instead of drawn; nullopt: none.
    std::optional<FrameNames> stored = {};
    /// Reports the number of drawn frames; false: cancel.
    std::function<bool(std::int64_t drawn)> should_continue = {};
};

/// Separate pictures, .png or .exr, numbered from `first`. Either all PNGs have alpha or
/// none has.
FramePipeline::Stages sequence_stages(const FrameNames& names, std::int64_t first,
                                      FrameAlpha alpha = FrameAlpha::none);
/// Writes HDR frames of pictures with this light into `film`, which must outlive the stages.
FramePipeline::Stages hdr_film_stages(FilmFile& film, const StoredLight& stored);
/// Writes into `film`, which must outlive the stages.
FramePipeline::Stages film_stages(FilmFile& film, FrameAlpha alpha);
/// Writes y4m to an open file descriptor.
FramePipeline::Stages pipe_stages(int descriptor, Extent extent, const FrameRateFraction& rate);
/// Shows the frames with `camera`, which must outlive the stages: each at its time, the first one
/// at once.
FramePipeline::Stages camera_stages(VirtualCamera& camera, Extent extent, double fps);

/// The stages of a job, with flash detection if requested. The job must outlive them.
FramePipeline::Stages watched_stages(const ExportJob& job);

/// The frames of an output without an end, about a year at 60 fps.
inline constexpr std::int64_t endless_frames = std::numeric_limits<int>::max();

/// Draws from a fresh start and writes on background threads. Each file is complete or missing.
/// False: cancelled. Stored pictures must all exist.
Result<bool> export_frames(Offline& offline, const ExportJob& job);

/// The sound of the frames: that of the signal, or of the video that the look processes at its own
/// speed. Empty without sound.
FilmSound sound_of(const Offline& offline, const ExportPart& part, double fps);

/// The default duration of a film from `start_seconds` on: the remaining sound or video, else 10 s.
/// Fails after the end of both.
Result<double> default_video_seconds(const Offline& offline, double start_seconds);
