#pragma once

#include "base/diagnostic.h"
#include "io/files/atomic_file.h"
#include "io/files/child_process.h"
#include "model/look/extent.h"
#include "model/picture/film_rate.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <thread>
#include <vector>

/// The sound of a film, in stereo; it begins with the first picture.
struct FilmSound {
    int rate = 0;            // samples a second; 0: there is no sound
    std::int64_t count = 0;  // samples of each channel
    /// The samples first, first + 1, ...: left and right in turn. On a thread of its own.
    std::function<void(std::int64_t first, std::span<float> samples)> read = {};
};

struct FilmFormat {
    Extent extent;
    FilmRate rate;
    FilmSound sound = {};
};

/// Whether a file's name says that it is a film that can be written: .mp4, .webm or .gif.
bool is_film_name(const std::filesystem::path& file);

/// A film that is being written by the program ffmpeg: .mp4 (H.264, AAC), .webm (VP9, Opus) or .gif
/// (no sound, at most 50 pictures a second: every second one, or fewer, of more). Its colours are
/// those of BT.709. Whole at the end, or not there at all.
class FilmFile {
public:
    /// Fails where the file cannot be written, and where ffmpeg is missing.
    static Result<std::unique_ptr<FilmFile>> create(const std::filesystem::path& file,
                                                    FilmFormat format);
    ~FilmFile();
    FilmFile(const FilmFile&) = delete;
    FilmFile& operator=(const FilmFile&) = delete;

    const Extent& extent() const { return m_format.extent; }
    /// The next picture: display_bytes(); waits while ffmpeg is busy.
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
    std::int64_t m_count = 0;  // pictures that were added
    std::thread m_sound;
};
