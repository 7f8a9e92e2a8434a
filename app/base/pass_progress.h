#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

/// Progress of long work on the passes of a look. The working thread reports it; other threads read
/// it and can cancel the work.
class PassProgress {
public:
    enum class Step { reading, linking, drawing };
    struct State {
        Step step = Step::reading;
        std::size_t done = 0;
        std::size_t total = 0;  // 0: not reported yet
        std::string pass;       // the current pass
        double seconds = 0.0;   // since the current pass began
    };
    using Listener = std::function<void(const State&)>;

    /// `listener` is called for each pass, on the working thread.
    explicit PassProgress(Listener listener = {});

    void begin(Step step, std::size_t total);
    /// Starts the next pass, which completes the previous one; false if cancelled.
    bool next(std::string_view pass);
    void cancel() { m_is_cancelled = true; }
    bool is_cancelled() const { return m_is_cancelled; }
    State state() const;

private:
    using Clock = std::chrono::steady_clock;

    Listener m_listener;
    std::atomic<bool> m_is_cancelled = false;
    mutable std::mutex m_mutex;
    State m_state;
    std::size_t m_begun = 0;
    Clock::time_point m_since = Clock::now();
};

/// "Linking: 3 of 12 passes", with the name of a slow pass.
std::string to_string(const PassProgress::State& state);
