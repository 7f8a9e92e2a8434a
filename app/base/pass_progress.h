#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

/// How far long work on the passes of a look has come: said by the thread that does it, read and
/// cancelled by others.
class PassProgress {
public:
    enum class Step { reading, linking, drawing };
    struct State {
        Step step = Step::reading;
        std::size_t done = 0;
        std::size_t total = 0;  // 0: nothing has been said yet
        std::string pass;       // that is worked on
        double seconds = 0.0;   // since it is
    };
    using Listener = std::function<void(const State&)>;

    /// `listener` is called with each pass, on the thread that works.
    explicit PassProgress(Listener listener = {});

    void begin(Step step, std::size_t total);
    /// The next pass is begun, and the one before it done; false: nobody wants it any more.
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

/// "Linking: 3 of 12 passes", and which pass is slow.
std::string words_of(const PassProgress::State& state);
