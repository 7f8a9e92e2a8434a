#pragma once

#include "base/diagnostic.h"
#include "base/work.h"

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <utility>

/// Long work on a thread of its own: one at a time.
template <class Outcome>
class BackgroundWork {
public:
    using Task = std::function<Result<Outcome>(Work& work)>;

    BackgroundWork() = default;
    ~BackgroundWork() { cancel(); }  // the future waits for its thread, which ends soon
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    /// Begins anew; what was found before is forgotten.
    void start(Task task) {
        cancel();
        m_outcome.reset();
        m_start = std::chrono::steady_clock::now();
        m_is_wanted = true;
        m_next = std::move(task);
        begin_next();
    }
    /// Nothing comes of what is under way.
    void cancel() {
        if (m_work)
            m_work->is_cancelled = true;
        m_is_wanted = false;
        m_next = nullptr;
    }
    /// To be called every turn.
    void update() {
        if (!m_coming.valid() ||
            m_coming.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return;
        auto outcome = m_coming.get();
        if (m_next)
            return begin_next();
        if (m_is_wanted)
            m_outcome = std::move(outcome);
        m_is_wanted = false;
    }

    bool is_running() const { return m_is_wanted && m_coming.valid(); }
    /// Nothing is under way, not even what was cancelled: start() need not wait for it.
    bool is_free() const { return !m_coming.valid(); }
    double share() const { return m_work && !m_next ? m_work->share.load() : 0.0; }
    /// At the pace so far; none while that says little.
    std::optional<double> seconds_left() const {
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - m_start;
        if (!is_running() || share() <= 0.0 || gone.count() < 2.0)
            return std::nullopt;
        return gone.count() * (1.0 - share()) / share();
    }
    /// None before the work has come to its end.
    const std::optional<Result<Outcome>>& outcome() const { return m_outcome; }

private:
    // Not beside what was cancelled and has not ended yet; nobody waits for that.
    void begin_next() {
        if (m_coming.valid())
            return;
        m_work = std::make_shared<Work>();
        m_coming = std::async(std::launch::async, [task = std::exchange(m_next, nullptr),
                                                   work = m_work] { return task(*work); });
    }

    std::shared_ptr<Work> m_work;  // shared with the thread
    Task m_next;
    std::chrono::steady_clock::time_point m_start;
    std::future<Result<Outcome>> m_coming;
    bool m_is_wanted = false;  // not cancelled
    std::optional<Result<Outcome>> m_outcome;
};
