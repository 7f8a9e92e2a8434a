#include "lab/offline/export.h"

#include "base/text.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/png_encoder.h"
#include "io/system/descriptor.h"
#include "io/video/video_sound.h"
#include "io/video/y4m.h"
#include "lab/offline/frame_export.h"
#include "lab/offline/offline.h"
#include "model/picture/display_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <thread>

namespace fs = std::filesystem;

namespace {
using PipedFrame = FramePipeline::Frame;
using FromFrame = FramePipeline::Made;

// All frames of a film must have the same size.
Result<void> check_size(const PipedFrame& frame, Extent extent) {
    const Extent now = frame.picture.extent;
    if (now == extent)
        return {};
    return fail({{},
                 0,
                 fmt::format("a video has one frame size: {} x {} px, but frame {} is {} x {} px",
                             extent.width, extent.height, frame.number, now.width, now.height)});
}

std::span<const std::uint8_t> as_numbers(const std::string& bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

Result<std::string> encoded(const RawPicture& picture, std::string_view extension,
                            FrameAlpha alpha) {
    if (alpha != FrameAlpha::none && extension == ".png")
        return encode_png_with_alpha(picture.extent, as_numbers(frame_bytes(picture, 8, alpha)));
    return encode_picture(picture, extension);
}

Result<void> write_video(int descriptor, std::string_view bytes) {
    if (!write_all(descriptor, bytes))
        return fail({{}, 0, fmt::format("can't write the video: {}", std::strerror(errno))});
    return {};
}
}  // namespace

ExportPart part_of(double start_seconds, double seconds, double fps) {
    constexpr double rounding = 1e-6;
    const std::int64_t first = std::llround(start_seconds * fps);
    const auto count = static_cast<std::int64_t>(std::ceil(seconds * fps - rounding));
    return {first, first + std::max<std::int64_t>(count, 1)};
}

FramePipeline::Stages sequence_stages(const FrameNames& names, std::int64_t first,
                                      FrameAlpha alpha) {
    const auto make = [names, first, alpha](const PipedFrame& frame) -> Result<FromFrame> {
        const auto file = names.name(static_cast<int>(frame.number));
        const auto bytes = encoded(frame.picture, to_lower(file.extension().string()), alpha);
        if (!bytes)
            return fail({file, 0, bytes.error().front().message});
        // Checking for leftovers before every file would take longer with each new file.
        const auto leftovers = frame.number == first ? Leftovers::removed : Leftovers::left;
        if (auto done = write_atomically(file, *bytes, leftovers); !done)
            return fail(done.error());
        return FromFrame{};
    };
    const bool is_exr = to_lower(names.name(0).extension().string()) == ".exr";
    return {make, [](std::int64_t, const FromFrame&) -> Result<void> { return {}; }, is_exr};
}

FramePipeline::Stages film_stages(FilmFile& film, FrameAlpha alpha) {
    const auto make = [&film, alpha](const PipedFrame& frame) -> Result<FromFrame> {
        if (const auto fits = check_size(frame, film.extent()); !fits)
            return fail(fits.error());
        return FromFrame{frame_bytes(frame.picture, film.encoding().bits(), alpha), {}};
    };
    return {make, [&film](std::int64_t, const FromFrame& made) { return film.add(made.bytes); },
            false};
}

FramePipeline::Stages hdr_film_stages(FilmFile& film, const StoredLight& stored) {
    const auto frames = std::make_shared<const HdrFrames>(*film.encoding().hdr, stored);
    const auto make = [&film, frames](const PipedFrame& frame) -> Result<FromFrame> {
        if (const auto fits = check_size(frame, film.extent()); !fits)
            return fail(fits.error());
        return FromFrame{frames->bytes(frame.picture), {}};
    };
    return {make, [&film](std::int64_t, const FromFrame& made) { return film.add(made.bytes); },
            false};
}

FramePipeline::Stages pipe_stages(int descriptor, Extent extent, const FrameRateFraction& rate) {
    const auto make = [extent](const PipedFrame& frame) -> Result<FromFrame> {
        if (const auto fits = check_size(frame, extent); !fits)
            return fail(fits.error());
        return FromFrame{y4m_frame(extent, display_bytes(frame.picture)), {}};
    };
    auto deliver = [descriptor, header = y4m_header(extent, rate)](
                       std::int64_t, const FromFrame& made) mutable -> Result<void> {
        if (auto done = write_video(descriptor, std::exchange(header, {})); !done)
            return done;
        return write_video(descriptor, made.bytes);
    };
    return {make, deliver, false};
}

FramePipeline::Stages camera_stages(VirtualCamera& camera, Extent extent, double fps) {
    using Clock = std::chrono::steady_clock;
    const auto make = [extent](const PipedFrame& frame) -> Result<FromFrame> {
        if (const auto fits = check_size(frame, extent); !fits)
            return fail(fits.error());
        return FromFrame{frame_bytes(frame.picture, 8, FrameAlpha::none), {}};
    };
    const std::chrono::duration<double> between(1.0 / fps);
    auto deliver = [&camera, between, next = Clock::time_point()](
                       std::int64_t, const FromFrame& made) mutable -> Result<void> {
        const auto now = Clock::now();
        std::this_thread::sleep_until(next);
        // A late frame does not hurry the following ones.
        next = std::max(next, now) + std::chrono::duration_cast<Clock::duration>(between);
        return camera.show(made.bytes);
    };
    return {make, deliver, false};
}

FramePipeline::Stages watched_stages(const ExportJob& job) {
    if (!job.flashes)
        return job.stages;
    const auto make = [&job](const PipedFrame& frame) {
        auto made = job.stages.make(frame);
        if (made)
            made->cells = cells_of(frame.picture);
        return made;
    };
    const auto deliver = [&job](std::int64_t number, const FromFrame& made) {
        job.flashes->add(made.cells, static_cast<double>(number + 1) / job.fps,
                         subframe_of(number + 1, job.subframes));
        return job.stages.deliver(number, made);
    };
    return {make, deliver, job.stages.steps_back};
}

namespace {
// The picture of the next frame, drawn or stored.
Result<void> make_frame(Offline& offline, const ExportJob& job, PipedFrame& frame) {
    if (!job.stored) {
        offline.read(job.pass, frame.picture);
        return {};
    }
    const auto picture = load_picture(job.stored->name(static_cast<int>(frame.number)));
    if (!picture)
        return fail(picture.error());
    frame.picture = raw_of(*picture);
    return {};
}
}  // namespace

Result<bool> export_frames(Offline& offline, const ExportJob& job) {
    FramePipeline pipeline(watched_stages(job));
    const std::int64_t begin = job.stored ? job.part.first : offline.frame_number();
    for (std::int64_t number = begin; number < job.part.end; ++number) {
        if (!job.should_continue(number)) {
            pipeline.cancel();
            return false;
        }
        if (number < job.part.first) {
            offline.advance_unseen();
            continue;
        }
        if (!job.stored)
            offline.advance();
        PipedFrame* const frame = pipeline.next();
        if (!frame)
            break;
        frame->number = number;
        if (auto made = make_frame(offline, job, *frame); !made) {
            pipeline.cancel();
            return fail(made.error());
        }
        pipeline.push(frame);
    }
    if (auto done = pipeline.finish(); !done)
        return fail(done.error());
    return true;
}

namespace {
FilmSound sound_of_video(const fs::path& video, const ExportPart& part, double fps) {
    const auto times = video_times(video);
    if (!times || !times->has_sound)
        return {};
    auto opened = VideoSound::open(video, static_cast<double>(part.first) / fps);
    if (!opened)
        return {};
    const double seconds = static_cast<double>(part.end - part.first) / fps;
    return {VideoSound::rate, std::llround(seconds * VideoSound::rate),
            [sound = std::shared_ptr<VideoSound>(std::move(*opened))](
                std::int64_t, std::span<float> samples) { sound->read(samples); }};
}
}  // namespace

FilmSound sound_of(const Offline& offline, const ExportPart& part, double fps) {
    const auto stream = offline.signal().sound_stream();
    if (!stream) {
        const fs::path video = source_video(offline.document());
        return video.empty() ? FilmSound{} : sound_of_video(video, part, fps);
    }
    const auto sample_at = [&](std::int64_t frame) {
        return std::llround(static_cast<double>(frame) / fps * stream->rate());
    };
    const std::int64_t first = sample_at(part.first);
    return {stream->rate(), sample_at(part.end) - first,
            [stream, first](std::int64_t from, std::span<float> samples) {
                std::vector<StereoSample> stereo(samples.size() / 2);
                stream->read(first + from, stereo);
                for (std::size_t i = 0; i < stereo.size(); ++i) {
                    samples[2 * i] = stereo[i].left;
                    samples[2 * i + 1] = stereo[i].right;
                }
            }};
}

Result<double> default_video_seconds(const Offline& offline, double start_seconds) {
    double length = offline.signal().sound_seconds();
    const char* what = "sound";
    if (const fs::path video = source_video(offline.document()); length <= 0.0 && !video.empty()) {
        length = video_times(video).value_or(VideoTimes{}).seconds;
        what = "video";
    }
    if (length <= 0.0)
        return film_seconds_without_sound;
    if (start_seconds >= length)
        return fail({{},
                     0,
                     fmt::format("nothing to export from {} s on: the {} ends at {} s",
                                 format_number(start_seconds), what, format_number(length))});
    return length - start_seconds;
}
