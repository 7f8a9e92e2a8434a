#include "lab/offline/export_queue.h"

#include <algorithm>
#include <utility>

namespace {
bool is_pending(const QueuedExport& entry) {
    return entry.state == QueuedExport::State::waiting ||
           entry.state == QueuedExport::State::running;
}
}  // namespace

int ExportQueue::add(std::filesystem::path file, Task task) {
    const int id = ++m_last_id;
    m_entries.push_back({.id = id, .file = std::move(file)});
    m_waiting.push_back({id, std::move(task)});
    start_next();
    return id;
}

void ExportQueue::cancel(int id) {
    QueuedExport* const entry = find(id);
    if (!entry)
        return;
    if (!::is_pending(*entry)) {
        std::erase_if(m_entries, [id](const QueuedExport& one) { return one.id == id; });
        return;
    }
    if (id == std::exchange(m_running, m_running == id ? 0 : m_running))
        m_work.cancel();
    std::erase_if(m_waiting, [id](const Waiting& one) { return one.id == id; });
    entry->state = QueuedExport::State::cancelled;
}

void ExportQueue::cancel_all() {
    std::vector<int> ids;
    for (const QueuedExport& entry : m_entries)
        if (::is_pending(entry))
            ids.push_back(entry.id);
    for (const int id : ids)
        cancel(id);
}

void ExportQueue::remove_ended() {
    std::erase_if(m_entries, [](const QueuedExport& entry) { return !::is_pending(entry); });
}

QueuedExport* ExportQueue::find(int id) {
    const auto found = std::ranges::find(m_entries, id, &QueuedExport::id);
    return found == m_entries.end() ? nullptr : &*found;
}

const QueuedExport* ExportQueue::running() const {
    const auto found = std::ranges::find(m_entries, m_running, &QueuedExport::id);
    return found == m_entries.end() ? nullptr : &*found;
}

int ExportQueue::pending() const {
    return static_cast<int>(std::ranges::count_if(m_entries, ::is_pending));
}

bool ExportQueue::is_target(const std::filesystem::path& file) const {
    return std::ranges::any_of(m_entries, [&](const QueuedExport& entry) {
        return ::is_pending(entry) && entry.file == file;
    });
}

void ExportQueue::start_next() {
    if (m_running != 0 || m_waiting.empty() || !m_work.is_free())
        return;
    Waiting next = std::move(m_waiting.front());
    m_waiting.pop_front();
    m_running = next.id;
    find(next.id)->state = QueuedExport::State::running;
    m_work.start(std::move(next.task));
}

// The list shows only the latest exports that have ended.
void ExportQueue::trim() {
    constexpr std::size_t most = 8;
    while (m_entries.size() > most) {
        const auto ended = std::ranges::find_if_not(m_entries, ::is_pending);
        if (ended == m_entries.end())
            return;
        m_entries.erase(ended);
    }
}

std::vector<QueuedExport> ExportQueue::update() {
    std::vector<QueuedExport> ended;
    m_work.update();
    QueuedExport* const entry = m_running != 0 ? find(m_running) : nullptr;
    if (entry && m_work.outcome() && !m_work.is_running()) {
        const Result<ExportResult>& outcome = *m_work.outcome();
        entry->state = outcome ? QueuedExport::State::done : QueuedExport::State::failed;
        if (outcome)
            entry->result = *outcome;
        else
            entry->reasons = outcome.error();
        ended.push_back(*entry);
        m_running = 0;
    }
    start_next();
    trim();
    return ended;
}
