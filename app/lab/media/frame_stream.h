#pragma once

#include "io/pictures/picture_reader.h"
#include "lab/media/read_ahead.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

/// Reads pictures of a sequence or video ahead on a background thread, a few at a time.
class FrameStream {
public:
    /// `name` is for messages.
    FrameStream(std::unique_ptr<PictureReader> reader, std::filesystem::path name, bool loops);
    ~FrameStream();
    FrameStream(const FrameStream&) = delete;
    FrameStream& operator=(const FrameStream&) = delete;

    /// Waits for the picture with this number, from 0; after the end it loops or holds the last
    /// one. If it is not readable, the previous one. Null: none was readable.
    SharedPicture wait(std::int64_t number);
    /// The same without waiting; null: not read yet.
    SharedPicture peek(std::int64_t number);
    void set_loop(bool loops);
    /// Converts all pictures read from now on, so that the drawing thread does not have to.
    void set_encoding(Encoding encoding) { m_encoding = encoding; }
    /// The new errors since the last call, each only once.
    Diagnostics take_problems();

private:
    void report(Diagnostic problem);
    void add(std::int64_t number, Result<std::optional<Picture>> read);
    void run();

    std::unique_ptr<PictureReader> m_reader;  // used by the thread
    std::filesystem::path m_name;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;   // wakes the thread
    std::condition_variable m_ready;  // wakes the waiting reader
    ReadAhead m_pictures;
    Diagnostics m_problems;
    Diagnostics m_reported;
    std::atomic<std::optional<Encoding>> m_encoding{std::nullopt};  // nullopt: unchanged
    bool m_is_ending = false;
    std::thread m_thread;
};
