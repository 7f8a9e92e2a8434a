#pragma once

#include "io/capture/video_capture.h"
#include "lab/media/read_ahead.h"
#include "model/look/picture.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

/// Keeps the newest picture of a live source, which it reads on a thread of its own. A source that
/// is lost keeps its last picture and is opened again every second.
class LiveStream {
public:
    using Open = std::function<Result<std::unique_ptr<VideoCapture>>()>;

    /// `open` runs on the thread. `name` is for messages. `rate`: pictures per second at most; 0:
    /// no limit.
    LiveStream(Open open, std::string name, double rate);
    ~LiveStream();
    LiveStream(const LiveStream&) = delete;
    LiveStream& operator=(const LiveStream&) = delete;

    /// Null: there was none yet.
    SharedPicture newest() const;
    /// Waits at most `seconds` for the first picture, or until opening has failed.
    SharedPicture wait_for_first(double seconds);
    /// Waits until this time after the first picture, s.
    void wait_until(double seconds) const;
    /// Whether it waits for the user, as VideoCapture::asks_user(), or for the first picture after
    /// that.
    bool asks_user() const { return m_asks_user; }
    /// Converts all pictures read from now on.
    void set_encoding(Encoding encoding) { m_encoding = encoding; }
    void set_rate(double rate) { m_rate = rate; }
    /// Why the picture is missing, old or incomplete, once per change.
    Diagnostics take_problems();
    /// Whether the last one of them has ended since the last call.
    bool take_solved();

private:
    void run();
    std::unique_ptr<VideoCapture> opened();
    void read(std::unique_ptr<VideoCapture>& input);
    void publish(Picture picture);
    void report(const std::string& message);
    bool pause(double seconds);

    Open m_open;
    std::string m_name;
    std::atomic<double> m_rate;
    std::atomic<bool> m_asks_user = false;
    std::atomic<std::optional<Encoding>> m_encoding{std::nullopt};  // nullopt: unchanged
    mutable std::mutex m_mutex;
    std::condition_variable m_ending;  // wakes the thread
    std::condition_variable m_ready;   // wakes the waiting reader
    SharedPicture m_newest;
    std::chrono::steady_clock::time_point m_begun;  // the first picture
    std::string m_reported;                         // the last problem; "": none at present
    Diagnostics m_problems;
    bool m_is_solved = false;
    bool m_is_ending = false;
    std::thread m_thread;
};
