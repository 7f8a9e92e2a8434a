#include "lab/reload/job_queue.h"

#include <doctest/doctest.h>

#include <thread>

namespace {
Job job_of(JobKind kind) {
    return {.kind = kind};
}

/// The job that the worker thread gets next.
std::optional<Job> next_job(JobQueue& queue) {
    std::optional<Job> job;
    CHECK(queue.wait(job, [] { return true; }) == JobQueue::Next::job);
    return job;
}

BuiltLook result_of(const Job& job) {
    return {.kind = job.kind};
}

constexpr std::array all_kinds{JobKind::look, JobKind::constants, JobKind::variant_constants,
                               JobKind::specialization};
}  // namespace

TEST_CASE("jobs are taken by kind: looks first, specialisations last") {
    JobQueue queue;
    queue.submit(job_of(JobKind::look));
    queue.submit(job_of(JobKind::variant_constants));
    queue.submit(job_of(JobKind::constants));
    queue.submit(job_of(JobKind::specialization));
    for (const JobKind kind : all_kinds)
        CHECK(next_job(queue)->kind == kind);
}

TEST_CASE("a kind is busy while its job waits or runs, and until its result is taken") {
    JobQueue queue;
    CHECK_FALSE(queue.is_busy(JobKind::constants));
    queue.submit(job_of(JobKind::constants));
    CHECK(queue.is_busy(JobKind::constants));
    const auto job = next_job(queue);
    CHECK(queue.is_busy(JobKind::constants));
    queue.finish(*job, result_of(*job));
    CHECK(queue.is_busy(JobKind::constants));
    CHECK(queue.take(JobKind::constants).has_value());
    CHECK_FALSE(queue.is_busy(JobKind::constants));
    CHECK_FALSE(queue.take(JobKind::constants).has_value());
}

TEST_CASE("a new look cancels the running job, and its result is discarded") {
    JobQueue queue;
    queue.submit(job_of(JobKind::look));
    const auto old = next_job(queue);
    queue.submit(job_of(JobKind::look));
    CHECK(old->progress->is_cancelled());
    queue.finish(*old, result_of(*old));
    CHECK_FALSE(queue.take(JobKind::look).has_value());
    const auto job = next_job(queue);
    queue.finish(*job, result_of(*job));
    CHECK(queue.take(JobKind::look).has_value());
}

TEST_CASE("a new look discards results of all other kinds") {
    JobQueue queue;
    queue.submit(job_of(JobKind::constants));
    const auto job = next_job(queue);
    queue.finish(*job, result_of(*job));
    queue.submit(job_of(JobKind::look));
    CHECK_FALSE(queue.take(JobKind::constants).has_value());
}

TEST_CASE("newer constants replace waiting ones, and the running ones are still delivered") {
    JobQueue queue;
    queue.submit(job_of(JobKind::constants));
    const auto running = next_job(queue);
    queue.submit(job_of(JobKind::constants));
    Job newest = job_of(JobKind::constants);
    newest.request.preset_file = "newest";
    queue.submit(newest);
    queue.finish(*running, result_of(*running));
    CHECK(queue.take(JobKind::constants).has_value());
    CHECK(next_job(queue)->request.preset_file == "newest");
}

TEST_CASE("constants cancel a specialisation, and cancelling a look cancels everything") {
    JobQueue queue;
    queue.submit(job_of(JobKind::specialization));
    queue.submit(job_of(JobKind::constants));
    CHECK_FALSE(queue.is_busy(JobKind::specialization));
    queue.submit(job_of(JobKind::specialization));
    queue.cancel(JobKind::look);
    for (const JobKind kind : all_kinds)
        CHECK_FALSE(queue.is_busy(kind));
}

TEST_CASE("the worker thread is idle only if there is idle work, and ends when asked") {
    JobQueue queue;
    std::optional<Job> job;
    CHECK(queue.wait(job, [] { return true; }) == JobQueue::Next::idle);
    std::thread worker([&] {
        std::optional<Job> none;
        CHECK(queue.wait(none, [] { return false; }) == JobQueue::Next::end);
        queue.note_ended();
    });
    queue.end();
    CHECK(queue.wait_until_ended(std::chrono::seconds(5)));
    worker.join();
}
