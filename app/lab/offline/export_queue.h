#pragma once

#include "lab/offline/frame_export.h"
#include "lab/storage/background_work.h"

#include <deque>
#include <filesystem>
#include <optional>
#include <vector>

/// An export that waits, runs or has ended.
struct QueuedExport {
    enum class State { waiting, running, done, failed, cancelled };

    int id = 0;
    std::filesystem::path file;
    State state = State::waiting;
    Diagnostics reasons = {};  // of a failed one
    ExportResult result = {};  // of a finished one
};

/// Exports in the background, one after another.
class ExportQueue {
public:
    using Task = BackgroundWork<ExportResult>::Task;

    /// Adds an export and returns its id.
    int add(std::filesystem::path file, Task task);
    /// Cancels an export that waits or runs; removes one that has ended from the list.
    void cancel(int id);
    void cancel_all();
    /// Removes the exports that have ended from the list.
    void remove_ended();

    /// In the order in which they were added.
    const std::deque<QueuedExport>& entries() const { return m_entries; }
    /// Null: none runs.
    const QueuedExport* running() const;
    /// The number of exports that run or wait.
    int pending() const;
    bool is_pending() const { return pending() > 0; }
    /// Whether a file is the target of an export that runs or waits.
    bool is_target(const std::filesystem::path& file) const;
    /// Of the running export: 0..1, and the estimated time left.
    double share() const { return m_work.share(); }
    std::optional<double> seconds_left() const { return m_work.seconds_left(); }

    /// Starts the next export. Returns those that have ended since the last call, without cancelled
    /// ones. Call it in every update.
    std::vector<QueuedExport> update();

private:
    struct Waiting {
        int id;
        Task task;
    };
    QueuedExport* find(int id);
    void start_next();
    void trim();

    std::deque<QueuedExport> m_entries;
    std::deque<Waiting> m_waiting;
    BackgroundWork<ExportResult> m_work;
    int m_running = 0;  // its id; 0: none
    int m_last_id = 0;
};
