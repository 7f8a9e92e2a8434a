#pragma once

#include "base/diagnostic.h"
#include "base/job_progress.h"

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <utility>

/// One long task at a time on a background thread.
template <class Outcome>
class BackgroundWork {
public:
    using Task = std::function<Result<Outcome>(JobProgress& work)>;

    BackgroundWork() = default;
    ~BackgroundWork() { cancel(); }  // the future waits for the thread, which ends soon
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    /// Starts a new task and discards the previous outcome.
    void start(Task task) {
        cancel();
        m_outcome.reset();
        m_start = std::chrono::steady_clock::now();
        m_is_wanted = true;
        m_next = std::move(task);
        begin_next();
    }
    /// Cancels the task and discards its outcome.
    void cancel() {
        if (m_work)
            m_work->is_cancelled = true;
        m_is_wanted = false;
        m_next = nullptr;
    }
    /// Call it in every update.
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
    /// Whether no task runs, not even a cancelled one, so that start() begins immediately.
    bool is_free() const { return !m_coming.valid(); }
    double share() const { return m_work && !m_next ? m_work->share.load() : 0.0; }
    /// Estimated from the progress so far; nullopt: too early to estimate.
    std::optional<double> seconds_left() const {
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - m_start;
        if (!is_running() || share() <= 0.0 || gone.count() < 2.0)
            return std::nullopt;
        return gone.count() * (1.0 - share()) / share();
    }
    /// nullopt: not finished.
    const std::optional<Result<Outcome>>& outcome() const { return m_outcome; }

private:
    // Waits in the queue until a cancelled task has ended, without blocking the caller.
    void begin_next() {
        if (m_coming.valid())
            return;
        m_work = std::make_shared<JobProgress>();
        m_coming = std::async(std::launch::async, [task = std::exchange(m_next, nullptr),
                                                   work = m_work] { return task(*work); });
    }

    std::shared_ptr<JobProgress> m_work;  // shared with the thread
    Task m_next;
    std::chrono::steady_clock::time_point m_start;
    std::future<Result<Outcome>> m_coming;
    bool m_is_wanted = false;  // not cancelled
    std::optional<Result<Outcome>> m_outcome;
};
