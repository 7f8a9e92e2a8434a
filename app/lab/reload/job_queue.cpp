#include "lab/reload/job_queue.h"

#include <algorithm>
#include <utility>

void JobQueue::clear(Slot& slot) {
    if (slot.running)
        slot.running->cancel();
    slot = {};
}

void JobQueue::submit(Job job) {
    {
        const std::lock_guard lock(m_mutex);
        if (job.kind == JobKind::look) {
            std::ranges::for_each(m_slots, clear);
            m_progress = job.progress;
        } else {
            clear(slot(JobKind::specialization));
        }
        slot(job.kind).waiting = std::move(job);
    }
    m_wake.notify_all();
}

void JobQueue::cancel(JobKind kind) {
    const std::lock_guard lock(m_mutex);
    if (kind == JobKind::look)
        std::ranges::for_each(m_slots, clear);
    else
        clear(slot(kind));
}

std::optional<BuiltLook> JobQueue::take(JobKind kind) {
    const std::lock_guard lock(m_mutex);
    return std::exchange(slot(kind).result, std::nullopt);
}

bool JobQueue::is_busy(JobKind kind) const {
    const std::lock_guard lock(m_mutex);
    return slot(kind).waiting || slot(kind).running || slot(kind).result;
}

PassProgress::State JobQueue::progress() const {
    const std::lock_guard lock(m_mutex);
    return m_progress ? m_progress->state() : PassProgress::State{};
}

// To be called with the mutex held.
bool JobQueue::take_next(std::optional<Job>& job) {
    for (Slot& next : m_slots)
        if (next.waiting) {
            job = std::exchange(next.waiting, std::nullopt);
            next.running = job->progress;
            return true;
        }
    return false;
}

JobQueue::Next JobQueue::wait(std::optional<Job>& job, const std::function<bool()>& has_idle_work) {
    constexpr auto idle_time = std::chrono::seconds(1);  // the first frames need the processor
    std::unique_lock lock(m_mutex);
    const auto has_next = [&] { return m_is_ending || take_next(job); };
    m_wake.wait(lock, [&] { return has_next() || has_idle_work(); });
    if (!m_is_ending && !job)
        m_wake.wait_for(lock, idle_time, has_next);
    return m_is_ending ? Next::end : job ? Next::job : Next::idle;
}

void JobQueue::finish(const Job& job, BuiltLook built) {
    const std::lock_guard lock(m_mutex);
    Slot& done = slot(job.kind);
    if (done.running == job.progress)
        done.running.reset();
    if (!job.progress->is_cancelled())
        done.result = std::move(built);
}

void JobQueue::wake() {
    {  // or a worker that has just asked for idle work would miss this
        const std::lock_guard lock(m_mutex);
    }
    m_wake.notify_all();
}

void JobQueue::end() {
    {
        const std::lock_guard lock(m_mutex);
        std::ranges::for_each(m_slots, clear);
        m_is_ending = true;
    }
    m_wake.notify_all();
}

void JobQueue::note_ended() {
    const std::lock_guard lock(m_mutex);
    m_has_ended = true;
    m_ended.notify_all();
}

bool JobQueue::wait_until_ended(std::chrono::milliseconds timeout) {
    std::unique_lock lock(m_mutex);
    return m_ended.wait_for(lock, timeout, [this] { return m_has_ended; });
}
