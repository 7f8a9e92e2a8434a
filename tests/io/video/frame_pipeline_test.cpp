#include "io/video/frame_pipeline.h"

#include <doctest/doctest.h>

#include <atomic>
#include <set>

namespace {
using PipedFrame = FramePipeline::Frame;
using FromFrame = FramePipeline::Made;

/// Blocks waiting threads until it is opened.
class Gate {
public:
    void open() {
        const std::lock_guard lock(m_mutex);
        m_is_open = true;
        m_changed.notify_all();
    }
    void wait() {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_is_open; });
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_is_open = false;
};

Result<FromFrame> named(const PipedFrame& frame) {
    return FromFrame{std::to_string(frame.number), {}};
}

// The number of frames that this machine encodes in parallel.
int at_once() {
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u,
                                       static_cast<unsigned>(FramePipeline::max_frames - 2)));
}

void push_all(FramePipeline& pipeline, int count) {
    for (int number = 0; number < count; ++number) {
        PipedFrame* frame = pipeline.next();
        if (!frame)
            return;
        frame->number = number;
        pipeline.push(frame);
    }
}
}  // namespace

TEST_CASE("frames are delivered complete and in order, whichever is encoded first") {
    Gate second_is_made;
    std::string delivered;
    FramePipeline pipeline({[&](const PipedFrame& frame) {
                                if (frame.number == 0 && at_once() > 1)
                                    second_is_made.wait();
                                if (frame.number == 1)
                                    second_is_made.open();
                                return named(frame);
                            },
                            [&](std::int64_t number, const FromFrame& made) -> Result<void> {
                                CHECK(made.bytes == std::to_string(number));
                                delivered += made.bytes + ' ';
                                return {};
                            }});
    push_all(pipeline, 12);
    CHECK(pipeline.finish().has_value());
    CHECK(delivered == "0 1 2 3 4 5 6 7 8 9 10 11 ");
}

TEST_CASE("the producer waits while the pipeline is full") {
    Gate all;
    std::atomic<int> given = 0;
    std::set<const PipedFrame*> frames;
    FramePipeline pipeline({[&](const PipedFrame& frame) {
                                all.wait();
                                return named(frame);
                            },
                            [](std::int64_t, const FromFrame&) -> Result<void> { return {}; }});
    std::thread drawing([&] {
        for (int number = 0; number < 40; ++number) {
            PipedFrame* frame = pipeline.next();
            frames.insert(frame);
            ++given;
            pipeline.push(frame);
        }
    });
    // While no frame is finished, the producer gets this far and no further.
    const auto in_a_moment = std::chrono::milliseconds(50);
    const int room = at_once() + 2;  // one that is drawn, and one that waits for an encoder
    while (given < room)
        std::this_thread::sleep_for(in_a_moment);
    std::this_thread::sleep_for(in_a_moment);
    CHECK(given == room);
    CHECK(room <= FramePipeline::max_frames);
    all.open();
    drawing.join();
    CHECK(pipeline.finish().has_value());
    CHECK(frames.size() <= FramePipeline::max_frames);
}

TEST_CASE("the first failing frame stops the pipeline and is named") {
    for (const bool when_delivered : {false, true}) {
        CAPTURE(when_delivered);
        std::atomic<int> maximum = 0;
        const auto failing = [](std::int64_t number) {
            return number >= 7 ? fail({"f_" + std::to_string(number), 0, "is full"})
                               : Result<void>();
        };
        FramePipeline pipeline(
            {[&](const PipedFrame& frame) -> Result<FromFrame> {
                 maximum = std::max<int>(maximum, static_cast<int>(frame.number));
                 if (!when_delivered)
                     if (auto done = failing(frame.number); !done)
                         return fail(done.error());
                 return named(frame);
             },
             [&](std::int64_t number, const FromFrame& frame) {
                 CHECK(frame.bytes == std::to_string(number));  // each number is delivered once
                 return failing(number);
             }});
        push_all(pipeline, 1000);
        const auto done = pipeline.finish();
        REQUIRE_FALSE(done.has_value());
        CHECK(to_string(done.error().front()) == "f_7: error: is full");
        CHECK(maximum <= 7 + FramePipeline::max_frames);
    }
}

TEST_CASE("of two failing frames the earlier one is named, whichever fails first") {
    if (at_once() < 2)
        return;
    for (const std::int64_t later : {0, 1}) {
        CAPTURE(later);
        Gate both_have_begun;
        Gate one_has_failed;
        FramePipeline pipeline(
            {[&](const PipedFrame& frame) -> Result<FromFrame> {
                 if (frame.number == later) {
                     both_have_begun.open();
                     one_has_failed.wait();
                 } else {
                     both_have_begun.wait();
                 }
                 return fail({"f_" + std::to_string(frame.number), 0, "is full"});
             },
             [](std::int64_t, const FromFrame&) -> Result<void> { return {}; }});
        push_all(pipeline, 2);
        while (pipeline.next()) {  // gives null after a failure
        }
        one_has_failed.open();
        const auto done = pipeline.finish();
        REQUIRE_FALSE(done.has_value());
        CHECK(done.error().front().file == "f_0");
    }
}

TEST_CASE("cancelling drops waiting frames, and frames in progress are completed") {
    Gate begun;
    Gate goes_on;
    std::atomic<int> made = 0;
    std::vector<std::int64_t> delivered;
    FramePipeline pipeline({[&](const PipedFrame& frame) {
                                begun.open();
                                goes_on.wait();
                                ++made;
                                return named(frame);
                            },
                            [&](std::int64_t number, const FromFrame&) -> Result<void> {
                                delivered.push_back(number);
                                return {};
                            }});
    push_all(pipeline, at_once() + 1);
    begun.wait();
    std::thread waking([&] {
        while (pipeline.next()) {  // gives null after cancelling
        }
        goes_on.open();
    });
    pipeline.cancel();
    waking.join();
    CHECK(made >= 1);
    CHECK(made <= at_once());
    CHECK(delivered.size() == static_cast<std::size_t>(made));
    for (std::size_t i = 0; i < delivered.size(); ++i)
        CHECK(delivered[i] == static_cast<std::int64_t>(i));
}
