#pragma once

#include "base/diagnostic.h"
#include "model/picture/flash.h"
#include "model/picture/raw_picture.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

/// Encodes pictures on several threads while one thread draws. At most max_frames are in memory;
/// the drawing thread waits for a free one.
class FramePipeline {
public:
    static constexpr int max_frames = 6;

    struct Frame {
        std::int64_t number = 0;
        RawPicture picture;
    };
    /// The result of encoding a frame.
    struct Made {
        std::string bytes;
        std::vector<Light> cells;
    };
    struct Stages {
        /// Runs on several threads in parallel.
        std::function<Result<Made>(const Frame& frame)> make;
        /// Runs one at a time in the order of push(), on any of the threads.
        std::function<Result<void>(std::int64_t number, Made made)> deliver;
        /// Encode at a lower priority than drawing; useful if encoding is expensive.
        bool steps_back = false;
    };

    explicit FramePipeline(Stages stages);
    /// Drops frames that are not started.
    ~FramePipeline();
    FramePipeline(const FramePipeline&) = delete;
    FramePipeline& operator=(const FramePipeline&) = delete;

    /// A frame to fill, with the memory of an earlier one; waits for it. Null after an error, which
    /// finish() returns.
    Frame* next();
    /// Queues the frame from next() for encoding.
    void push(Frame* frame);
    /// Waits until all frames are delivered; otherwise returns the error of the first failed frame.
    Result<void> finish();
    /// Drops frames that are not started, and waits for the others.
    void cancel();

private:
    struct Slot {
        enum class State { free, filled, waiting, worked, made };

        Frame frame;
        State state = State::free;
        std::uint64_t number = 0;
        Made made;
    };
    using Lock = std::unique_lock<std::mutex>;

    void work();
    Slot* find(Slot::State state);
    void make(Slot& slot, Lock& lock);
    void deliver_made(Lock& lock);
    void note_error(std::uint64_t number, Diagnostics reasons);
    void free(Slot& slot);
    void join();

    Stages m_stages;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<Slot> m_slots;
    std::uint64_t m_pushed = 0;     // number of frames pushed
    std::uint64_t m_delivered = 0;  // the number of the next one
    bool m_is_delivering = false;
    bool m_is_ending = false;
    bool m_is_dropping = false;  // no further frame is started
    std::uint64_t m_failed_number = 0;
    std::optional<Diagnostics> m_error;
    std::vector<std::thread> m_threads;
};
