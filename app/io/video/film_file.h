#pragma once

#include "base/diagnostic.h"
#include "io/files/atomic_file.h"
#include "io/system/child_process.h"
#include "io/video/film_codec.h"
#include "model/look/extent.h"
#include "model/picture/frame_rate_fraction.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <thread>
#include <vector>

/// The stereo sound of a film; it starts with the first picture.
struct FilmSound {
    int rate = 0;            // samples per second; 0: no sound
    std::int64_t count = 0;  // samples per channel
    /// Reads interleaved left and right samples from index `first`. Called on its own thread.
    std::function<void(std::int64_t first, std::span<float> samples)> read = {};
};

struct FilmFormat {
    Extent extent;
    FrameRateFraction rate;
    FilmSound sound = {};
    FilmEncoding encoding;
    double timeout_seconds = 60.0;  // how long ffmpeg may make no progress
};

/// A film that is written by ffmpeg. A GIF has at most 50 pictures per second; at higher rates only
/// every second (or third, ...) is kept. BT.709 colours, or RGB if lossless. The file appears only
/// when complete.
class FilmFile {
public:
    /// Fails if the file can't be written or ffmpeg is missing.
    static Result<std::unique_ptr<FilmFile>> create(const std::filesystem::path& file,
                                                    FilmFormat format);
    ~FilmFile();
    FilmFile(const FilmFile&) = delete;
    FilmFile& operator=(const FilmFile&) = delete;

    const Extent& extent() const { return m_format.extent; }
    const FilmEncoding& encoding() const { return m_format.encoding; }
    /// Adds the next picture: RGB or RGBA with 8 or 16 bits per channel, as the encoding says, row
    /// 0 at the top. Waits while ffmpeg is busy. Fails if ffmpeg has ended or is stuck.
    Result<void> add(std::string_view pixels);
    Result<void> finish();

private:
    FilmFile(std::filesystem::path file, FilmFormat format, AtomicFile target,
             ChildProcess process);
    void feed_sound();
    bool feed_lead_in();
    bool feed_samples(std::span<const float> samples);
    tl::unexpected<Diagnostics> failed();

    std::filesystem::path m_file;
    FilmFormat m_format;
    AtomicFile m_target;
    ChildProcess m_process;
    std::int64_t m_count = 0;  // number of pictures added
    std::thread m_sound;
};
