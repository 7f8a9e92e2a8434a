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

/// Pictures on their way to files: while one thread draws, others encode. Never more than
/// most_frames are in memory; who draws waits until one is done with.
class FramePipeline {
public:
    static constexpr int most_frames = 6;

    struct Frame {
        std::int64_t number = 0;
        RawPicture picture;
    };
    /// What is made of a frame.
    struct Made {
        std::string bytes;
        std::vector<Light> cells;
    };
    struct Stages {
        /// On several threads at once.
        std::function<Result<Made>(const Frame& frame)> make;
        /// One after the other, in the order of push(); on any of the threads.
        std::function<Result<void>(std::int64_t number, Made made)> deliver;
        /// Drawing goes first: pays where much is to be made of a frame.
        bool steps_back = false;
    };

    explicit FramePipeline(Stages stages);
    /// What is not begun is dropped.
    ~FramePipeline();
    FramePipeline(const FramePipeline&) = delete;
    FramePipeline& operator=(const FramePipeline&) = delete;

    /// A frame to be filled, which has the memory of an earlier one; waits for it. Null where
    /// something has failed: finish() says what.
    Frame* next();
    /// The frame that next() gave goes on its way.
    void push(Frame* frame);
    /// Waits until all is delivered; else says what is wrong with the first frame that failed.
    Result<void> finish();
    /// Drops what is not begun, and waits for the rest.
    void cancel();

private:
    struct Slot {
        enum class State { free, filled, waiting, worked, made };

        Frame frame;
        State state = State::free;
        std::uint64_t turn = 0;
        Made made;
    };
    using Lock = std::unique_lock<std::mutex>;

    void work();
    Slot* find(Slot::State state);
    void make(Slot& slot, Lock& lock);
    void deliver_made(Lock& lock);
    void note_error(std::uint64_t turn, Diagnostics reasons);
    void free(Slot& slot);
    void join();

    Stages m_stages;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<Slot> m_slots;
    std::uint64_t m_pushed = 0;     // turns given out
    std::uint64_t m_delivered = 0;  // the turn that is next
    bool m_is_delivering = false;
    bool m_is_ending = false;
    bool m_is_dropping = false;  // nothing is begun any more
    std::uint64_t m_failed_turn = 0;
    std::optional<Diagnostics> m_error;
    std::vector<std::thread> m_threads;
};
