#include "io/sound/beam_queue.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace {
constexpr int queue_rate = 48000;

/// A constant beam position for a number of frames.
std::vector<float> at(float x, float y, std::size_t frames) {
    std::vector<float> stereo;
    for (std::size_t i = 0; i < frames; ++i)
        stereo.insert(stereo.end(), {x, y});
    return stereo;
}

std::vector<float> mixed(BeamQueue& queue, std::size_t frames) {
    std::vector<float> stereo(2 * frames, 9.0f);
    queue.mix(stereo);
    return stereo;
}

// Brings the queue to full level and to a position, so that the ramps to both are over.
void specialize(BeamQueue& queue, float x, float y) {
    queue.set_level(1.0);
    queue.write(at(x, y, 500));
    mixed(queue, 100);
    mixed(queue, 400);
}

float largest_step(const std::vector<float>& stereo, float before) {
    float step = 0.0f;
    for (std::size_t i = 0; i < stereo.size(); i += 2) {
        step = std::max(step, std::abs(stereo[i] - before));
        before = stereo[i];
    }
    return step;
}
}  // namespace

TEST_CASE("queued samples are played unchanged, and then the last position is held") {
    BeamQueue queue(queue_rate);
    specialize(queue, 0.0f, 0.0f);
    std::vector<float> ramp;
    for (int i = 0; i < 300; ++i)
        ramp.insert(ramp.end(),
                    {static_cast<float>(i) / 1024.0f, static_cast<float>(-i) / 2048.0f});
    queue.write(ramp);
    CHECK(queue.waiting() == 300);
    std::vector<float> heard = mixed(queue, 128);
    for (const float sample : mixed(queue, 172))
        heard.push_back(sample);
    CHECK(heard == ramp);
    CHECK(queue.waiting() == 0);
    CHECK(mixed(queue, 50) == at(ramp[598], ramp[599], 50));
}

TEST_CASE("the level is a factor clamped to 0 .. 1, ramped over one buffer") {
    BeamQueue queue(queue_rate);
    specialize(queue, 0.5f, -1.0f);
    queue.set_level(0.25);
    const std::vector<float> heard = mixed(queue, 480);
    CHECK(largest_step(heard, 0.5f) < 1e-3f);
    CHECK(mixed(queue, 1) == at(0.125f, -0.25f, 1));
    queue.set_level(7.0);
    mixed(queue, 10);
    CHECK(mixed(queue, 1) == at(0.5f, -1.0f, 1));
}

TEST_CASE("after a jump the beam moves linearly to its new position within 5 ms") {
    BeamQueue queue(queue_rate);
    specialize(queue, 0.75f, 0.0f);
    queue.write(at(0.75f, 0.0f, 1000));
    mixed(queue, 10);
    queue.start_anew();
    CHECK(queue.waiting() == 0);
    queue.write(at(-0.75f, 0.0f, 1000));
    const std::vector<float> heard = mixed(queue, 400);
    const float frames = queue_rate / 200.0f;
    CHECK(largest_step(heard, 0.75f) <= 1.5f / frames * 1.001f);
    CHECK(heard[2 * 239] > -0.75f);
    CHECK(heard[2 * 241] == -0.75f);
    CHECK(queue.waiting() == 600);
}

TEST_CASE("samples after a gap are joined without a click") {
    BeamQueue queue(queue_rate);
    specialize(queue, -0.5f, 0.0f);
    mixed(queue, 1000);
    queue.write(at(0.5f, 0.0f, 480));
    CHECK(largest_step(mixed(queue, 480), -0.5f) <= 1.0f / 240.0f * 1.001f);
}

TEST_CASE("the queue holds one second, and samples are clamped to -1 .. 1") {
    BeamQueue queue(1000);
    queue.set_level(1.0);
    queue.write(at(3.0f, -3.0f, 5000));
    CHECK(queue.waiting() == 1000);
    mixed(queue, 500);
    CHECK(mixed(queue, 1) == at(1.0f, -1.0f, 1));
}

TEST_CASE("with a writing and a playing thread, each sample is played once and in order") {
    BeamQueue queue(queue_rate);
    constexpr int count = 200000;
    specialize(queue, 0.0f, 0.0f);
    std::atomic<bool> is_done = false;
    std::thread writer([&] {
        for (int i = 1; i <= count;) {
            if (queue.waiting() > 4000) {
                std::this_thread::yield();
                continue;
            }
            std::vector<float> some;
            for (int n = 0; n < 100; ++n, ++i)
                some.insert(some.end(), {static_cast<float>(i) / (1 << 18), 0.0f});
            queue.write(some);
        }
        is_done = true;
    });
    float last = 0.0f;
    bool is_in_order = true;
    while (!is_done || queue.waiting() > 0) {
        const std::vector<float> heard = mixed(queue, 64);
        for (std::size_t i = 0; i < heard.size(); i += 2) {
            is_in_order = is_in_order && heard[i] >= last && heard[i] - last < 0.01f;
            last = heard[i];
        }
    }
    writer.join();
    CHECK(is_in_order);
    CHECK(last > 0.99f * static_cast<float>(count) / (1 << 18));
}
