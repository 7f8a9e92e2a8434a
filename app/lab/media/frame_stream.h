#pragma once

#include "io/pictures/picture_reader.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

/// Drawn by one thread while another reads on; immutable, so that both may hold it.
using SharedPicture = std::shared_ptr<const Picture>;

/// Reads the pictures of a sequence or video ahead of time, on a thread of its own, a few at once.
class FrameStream {
public:
    /// `name` is for what is told.
    FrameStream(std::unique_ptr<PictureReader> reader, std::filesystem::path name, bool loops);
    ~FrameStream();
    FrameStream(const FrameStream&) = delete;
    FrameStream& operator=(const FrameStream&) = delete;

    /// The picture with that number from 0, after the last one as `loops` says. Waits until it has
    /// been read. Where it cannot be read the one before it stays; null when there never was one.
    SharedPicture wait(std::int64_t number);
    /// The same without waiting: null while it is not there yet.
    SharedPicture peek(std::int64_t number);
    void set_loop(bool loops);
    /// Of the colours of what is read from now on: who draws it needs not take them there.
    void set_encoding(Encoding encoding) { m_encoding = encoding; }
    /// What could not be read since last asked, each once.
    Diagnostics take_problems();

private:
    std::int64_t resolved(std::int64_t number) const;
    SharedPicture find(std::int64_t number);
    std::optional<std::int64_t> next_to_read() const;
    void tell(Diagnostic problem);
    void keep(std::int64_t number, Result<std::optional<Picture>> read);
    void run();

    std::unique_ptr<PictureReader> m_reader;  // the thread's
    std::filesystem::path m_name;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;   // of the thread
    std::condition_variable m_ready;  // of who waits for it
    std::map<std::int64_t, SharedPicture> m_pictures;
    SharedPicture m_latest;
    Diagnostics m_problems;
    Diagnostics m_told;
    std::optional<std::int64_t> m_count;
    std::int64_t m_wanted = 0;
    std::size_t m_most = 4;  // kept at once
    bool m_loops;
    std::atomic<std::optional<Encoding>> m_encoding{std::nullopt};  // none: as it is read
    bool m_is_ending = false;
    std::thread m_thread;
};
