#include "lab/reload/build_worker.h"

#include "lab/storage/shader_cache.h"

BuildWorker::BuildWorker(std::unique_ptr<gpu::Context> context, const gpu::Context& screen,
                         const Roots& roots)
    : m_store(shader_cache(roots)),
      m_context(std::move(context), screen),
      m_reader(roots, m_store.get()),
      m_builder(m_context, m_store),
      m_thread([this] { run(); }) {}

BuildWorker::~BuildWorker() {
    m_queue.end();
    m_thread.join();
}

void BuildWorker::allow_preparation() {
    if (!m_may_prepare.exchange(true))
        m_queue.wake();
}

bool BuildWorker::end(std::chrono::milliseconds timeout) {
    m_queue.end();
    return m_queue.wait_until_ended(timeout);
}

void BuildWorker::run() {
    const auto has_idle_work = [this] { return m_may_prepare && m_builder.can_prepare(); };
    for (;;) {
        std::optional<Job> job;
        const JobQueue::Next next = m_queue.wait(job, has_idle_work);
        if (next == JobQueue::Next::end)
            break;
        if (next == JobQueue::Next::idle) {
            m_builder.prepare();
            continue;
        }
        m_queue.finish(*job, work_on(*job));
        if (m_wake_owner)
            m_wake_owner();
    }
    m_builder.clear();
    m_context.release();
    m_queue.note_ended();
}

BuiltLook BuildWorker::work_on(Job& job) {
    if (job.specialization)
        return m_builder.build_specialized(job);
    BuiltLook built{.kind = job.kind, .request = job.request, .is_reload = job.is_reload};
    LoadedLook read = m_reader.read(job);
    built.files = std::move(read.files);
    built.problems = std::move(read.warnings);
    if (!read.look) {
        const Diagnostics& why = read.look.error();
        built.problems.insert(built.problems.begin(), why.begin(), why.end());
        return built;
    }
    built.look = std::move(*read.look);
    m_builder.build(job, built);
    return built;
}
