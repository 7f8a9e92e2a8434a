#pragma once

#include "lab/reload/job_queue.h"
#include "lab/reload/look_reader.h"
#include "lab/reload/program_builder.h"

#include <atomic>
#include <functional>
#include <thread>

/// The worker thread: reads looks and builds their programs.
class BuildWorker {
public:
    /// The arguments as of LookLoader.
    BuildWorker(std::unique_ptr<gpu::Context> context, const gpu::Context& screen,
                const Roots& roots);
    /// Waits for the thread.
    ~BuildWorker();
    BuildWorker(const BuildWorker&) = delete;
    BuildWorker& operator=(const BuildWorker&) = delete;

    JobQueue& queue() { return m_queue; }
    const JobQueue& queue() const { return m_queue; }
    LookReader& reader() { return m_reader; }
    ProgramBuilder& builder() { return m_builder; }
    const ProgramBuilder& builder() const { return m_builder; }
    WorkerContext& context() { return m_context; }

    /// Called on the thread after each job. To be set before the first job.
    void set_wake(std::function<void()> wake) { m_wake_owner = std::move(wake); }
    /// From now on an idle thread prepares for edits.
    void allow_preparation();
    /// Ends the thread; false if it did not end in time, because it hangs in a driver. Then this
    /// must not be destroyed.
    bool end(std::chrono::milliseconds timeout);

private:
    void run();
    BuiltLook work_on(Job& job);

    std::shared_ptr<ByteStore> m_store;
    WorkerContext m_context;
    JobQueue m_queue;
    LookReader m_reader;
    ProgramBuilder m_builder;
    std::function<void()> m_wake_owner;
    std::atomic<bool> m_may_prepare = false;
    std::thread m_thread;
};
