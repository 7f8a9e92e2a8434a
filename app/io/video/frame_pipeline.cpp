#include "io/video/frame_pipeline.h"

#include <algorithm>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace {
// More would only wait: drawing uses all cores, and libraries have their own threads.
unsigned encoder_count() {
    constexpr unsigned maximum = FramePipeline::max_frames - 2;  // one is drawn, one is next
    return std::clamp(std::thread::hardware_concurrency(), 1u, maximum);
}

// Gives drawing priority: it has single-threaded stretches, which encoding then fills.
void step_back() {
    constexpr int behind = 5;
    const auto self = static_cast<id_t>(::gettid());
    ::setpriority(PRIO_PROCESS, self, ::getpriority(PRIO_PROCESS, self) + behind);
}
}  // namespace

FramePipeline::FramePipeline(Stages stages)
    : m_stages(std::move(stages)), m_slots(encoder_count() + 2) {
    for (unsigned i = 0; i < encoder_count(); ++i)
        m_threads.emplace_back([this] { work(); });
}

FramePipeline::~FramePipeline() {
    cancel();
}

FramePipeline::Slot* FramePipeline::find(Slot::State state) {
    Slot* first = nullptr;
    for (Slot& slot : m_slots)
        if (slot.state == state && (!first || slot.number < first->number))
            first = &slot;
    return first;
}

FramePipeline::Frame* FramePipeline::next() {
    Lock lock(m_mutex);
    Slot* slot = nullptr;
    m_changed.wait(lock,
                   [&] { return m_is_dropping || (slot = find(Slot::State::free)) != nullptr; });
    if (m_is_dropping)
        return nullptr;
    slot->state = Slot::State::filled;
    return &slot->frame;
}

void FramePipeline::push(Frame* frame) {
    const Lock lock(m_mutex);
    const auto slot =
        std::ranges::find_if(m_slots, [&](const Slot& one) { return &one.frame == frame; });
    slot->number = m_pushed++;
    slot->state = Slot::State::waiting;
    m_changed.notify_all();
}

void FramePipeline::work() {
    if (m_stages.steps_back)
        step_back();
    Lock lock(m_mutex);
    for (;;) {
        Slot* slot = nullptr;
        m_changed.wait(lock, [&] {
            slot = m_is_dropping ? nullptr : find(Slot::State::waiting);
            return slot || m_is_ending || m_is_dropping;
        });
        if (!slot)
            return;
        make(*slot, lock);
        deliver_made(lock);
    }
}

void FramePipeline::make(Slot& slot, Lock& lock) {
    slot.state = Slot::State::worked;
    lock.unlock();
    auto made = m_stages.make(slot.frame);
    lock.lock();
    if (!made) {
        note_error(slot.number, std::move(made.error()));
        return;
    }
    slot.made = std::move(*made);
    slot.state = Slot::State::made;
}

// The thread that made the next frame delivers it, and the made frames after it.
void FramePipeline::deliver_made(Lock& lock) {
    if (m_is_delivering)
        return;
    m_is_delivering = true;
    for (;;) {
        Slot* slot = find(Slot::State::made);
        if (!slot || slot->number != m_delivered)
            break;
        lock.unlock();
        auto done = m_stages.deliver(slot->frame.number, std::move(slot->made));
        lock.lock();
        if (!done) {
            note_error(slot->number, std::move(done.error()));
            free(*slot);  // m_delivered is unchanged, so no later frame is delivered
            break;
        }
        ++m_delivered;
        free(*slot);
    }
    m_is_delivering = false;
}

void FramePipeline::note_error(std::uint64_t number, Diagnostics reasons) {
    if (!m_error || number < m_failed_number) {
        m_error = std::move(reasons);
        m_failed_number = number;
    }
    m_is_dropping = true;
    m_changed.notify_all();
}

void FramePipeline::free(Slot& slot) {
    slot.state = Slot::State::free;
    m_changed.notify_all();
}

void FramePipeline::join() {
    for (std::thread& thread : m_threads)
        thread.join();
    m_threads.clear();
}

Result<void> FramePipeline::finish() {
    {
        const Lock lock(m_mutex);
        m_is_ending = true;
        m_changed.notify_all();
    }
    join();
    if (m_error)
        return fail(*m_error);
    return {};
}

void FramePipeline::cancel() {
    {
        const Lock lock(m_mutex);
        m_is_dropping = true;
        m_changed.notify_all();
    }
    join();
}
