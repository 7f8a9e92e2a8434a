#include "lab/offline/export_queue.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace {
using State = QueuedExport::State;

// A task that ends when it is told to, or is cancelled.
struct Controlled {
    std::shared_ptr<std::atomic<bool>> is_over = std::make_shared<std::atomic<bool>>(false);
    bool fails = false;

    ExportQueue::Task task() const {
        return [is_over = is_over, fails = fails](JobProgress& work) -> Result<ExportResult> {
            while (!*is_over && !work.is_cancelled)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (fails)
                return fail({{}, 0, "the disk is full"});
            return ExportResult{"made", 3, {4, 4}, {}};
        };
    }
};

std::vector<QueuedExport> updated_until(ExportQueue& queue, int pending) {
    std::vector<QueuedExport> ended;
    const auto start = std::chrono::steady_clock::now();
    while (queue.pending() > pending &&
           std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
        for (QueuedExport& one : queue.update())
            ended.push_back(std::move(one));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(queue.pending() == pending);
    return ended;
}
}  // namespace

TEST_CASE("exports run one after another in their order") {
    ExportQueue queue;
    CHECK(!queue.is_pending());
    const Controlled first;
    const Controlled second{.fails = true};
    queue.add("a.mp4", first.task());
    queue.add("b.mp4", second.task());
    CHECK(queue.pending() == 2);
    CHECK(queue.is_target("b.mp4"));
    CHECK(queue.entries()[0].state == State::running);
    CHECK(queue.entries()[1].state == State::waiting);
    *first.is_over = true;
    const auto ended = updated_until(queue, 1);
    REQUIRE(ended.size() == 1);
    CHECK(ended[0].state == State::done);
    CHECK(ended[0].result.frames == 3);
    REQUIRE(queue.running());
    CHECK(queue.running()->file == "b.mp4");
    *second.is_over = true;
    const auto failed = updated_until(queue, 0);
    REQUIRE(failed.size() == 1);
    CHECK(failed[0].state == State::failed);
    CHECK(failed[0].reasons.front().message == "the disk is full");
    CHECK(!queue.is_target("b.mp4"));
    queue.remove_ended();
    CHECK(queue.entries().empty());
}

TEST_CASE("a cancelled export makes room for the next one") {
    ExportQueue queue;
    const Controlled first;
    const Controlled second;
    const Controlled third;
    const int running = queue.add("a.mp4", first.task());
    const int waiting = queue.add("b.mp4", second.task());
    queue.add("c.mp4", third.task());
    queue.cancel(waiting);
    CHECK(queue.entries()[1].state == State::cancelled);
    queue.cancel(running);
    CHECK(queue.pending() == 1);
    *third.is_over = true;
    const auto ended = updated_until(queue, 0);
    REQUIRE(ended.size() == 1);
    CHECK(ended[0].file == "c.mp4");
    queue.cancel(running);  // an ended one leaves the list
    CHECK(queue.entries().size() == 2);
}

TEST_CASE("all exports can be cancelled") {
    ExportQueue queue;
    const Controlled first;
    const Controlled second;
    queue.add("a.mp4", first.task());
    queue.add("b.mp4", second.task());
    queue.cancel_all();
    CHECK(!queue.is_pending());
    CHECK(!queue.running());
    CHECK(queue.update().empty());
}
