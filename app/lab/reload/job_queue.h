#pragma once

#include "base/pass_progress.h"
#include "graph/warm_up/look_contexts.h"
#include "lab/reload/built_look.h"
#include "lab/reload/pass_selection.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>

/// A job of the worker thread.
struct Job {
    JobKind kind = JobKind::look;
    OpenRequest request = {};
    bool is_reload = false;   // of the open look
    bool is_opening = false;  // no programs of the open look are reused
    PassSelection seen = {};
    std::shared_ptr<PassProgress> progress = std::make_shared<PassProgress>();
    std::shared_ptr<const Programs> shown = {};  // of the open look; null: is_opening
    std::shared_ptr<gpu::Context> context = {};  // that draws the look
    // While opening: the context that will draw the look, and its owner; null: none is available.
    std::shared_future<std::shared_ptr<LookContext>> coming_context = {};
    std::shared_ptr<LookContext> look_context = {};
    std::shared_ptr<const SpecializationKey> key = {};  // static values of the picture; null: none
    std::shared_ptr<const SpecializationRequest> specialization = {};  // of that kind
};

/// Jobs and results between the window's thread and the worker thread: one waiting job and one
/// result per kind. All functions are thread-safe.
class JobQueue {
public:
    /// Replaces the waiting job of its kind. A look cancels all other jobs and discards their
    /// results; constants cancel a specialisation.
    void submit(Job job);
    /// Cancels the jobs of a kind and discards their result; for a look, those of all kinds.
    void cancel(JobKind kind);
    /// The result of a job that was not cancelled, once.
    std::optional<BuiltLook> take(JobKind kind);
    /// Whether a job waits, runs, or has a result.
    bool is_busy(JobKind kind) const;
    /// Of the newest look.
    PassProgress::State progress() const;

    enum class Next { job, idle, end };
    /// For the worker thread. Waits for a job, the most important kind first. Returns idle after a
    /// second without one if there is idle work.
    Next wait(std::optional<Job>& job, const std::function<bool()>& has_idle_work);
    /// The result of a job that wait() returned. Discarded if the job was cancelled.
    void finish(const Job& job, BuiltLook built);
    /// Makes wait() ask again for idle work.
    void wake();

    /// Cancels all jobs and makes wait() return end.
    void end();
    /// The worker thread calls this last.
    void note_ended();
    /// Whether the worker thread ended within this time.
    bool wait_until_ended(std::chrono::milliseconds timeout);

private:
    struct Slot {
        std::optional<Job> waiting;
        std::shared_ptr<PassProgress> running;  // of the job at the worker; null: none
        std::optional<BuiltLook> result;
    };
    Slot& slot(JobKind kind) { return m_slots[static_cast<std::size_t>(kind)]; }
    const Slot& slot(JobKind kind) const { return m_slots[static_cast<std::size_t>(kind)]; }
    static void clear(Slot& slot);
    bool take_next(std::optional<Job>& job);

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::condition_variable m_ended;
    std::array<Slot, job_kinds> m_slots;
    std::shared_ptr<PassProgress> m_progress;  // of the newest look
    bool m_is_ending = false;
    bool m_has_ended = false;
};
