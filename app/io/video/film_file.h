#pragma once

#include "base/diagnostic.h"
#include "io/files/atomic_file.h"
#include "io/system/child_process.h"
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
};

/// Whether the extension is a film format that can be written: .mp4, .webm or .gif.
bool is_film_name(const std::filesystem::path& file);

/// A film that is written by ffmpeg: .mp4 (H.264, AAC), .webm (VP9, Opus) or .gif. A GIF has no
/// sound and at most 50 pictures per second; at higher rates only every second (or third, ...) is
/// kept. BT.709 colours. The file appears only when complete.
class FilmFile {
public:
    /// Fails if the file can't be written or ffmpeg is missing.
    static Result<std::unique_ptr<FilmFile>> create(const std::filesystem::path& file,
                                                    FilmFormat format);
    ~FilmFile();
    FilmFile(const FilmFile&) = delete;
    FilmFile& operator=(const FilmFile&) = delete;

    const Extent& extent() const { return m_format.extent; }
    /// Adds the next picture, from display_bytes(); waits while ffmpeg is busy.
    Result<void> add(std::span<const std::uint8_t> rgb);
    Result<void> finish();

private:
    FilmFile(std::filesystem::path file, FilmFormat format, AtomicFile target,
             ChildProcess process);
    void feed_sound();
    tl::unexpected<Diagnostics> failed();

    std::filesystem::path m_file;
    FilmFormat m_format;
    AtomicFile m_target;
    ChildProcess m_process;
    std::int64_t m_count = 0;  // number of pictures added
    std::thread m_sound;
};
