#include "signals/audio/upsampler.h"

#include "about.h"
#include "signals/signal_making.h"

#include <random>

namespace {
std::shared_ptr<const Sound> noise_sound(int frames) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> level(-1.0f, 1.0f);
    return sound_of(
        48000, frames, [&](int) { return level(random); }, [&](int) { return level(random); });
}

std::vector<StereoSample> read(const Upsampler& upsampler, std::int64_t first, std::size_t count) {
    std::vector<StereoSample> samples(count);
    upsampler.read(first, samples);
    return samples;
}
}  // namespace

TEST_CASE("every upsampling factor keeps the original samples") {
    const auto sound = noise_sound(1000);
    for (int factor = 1; factor <= 16; ++factor) {
        const Upsampler upsampler(stream_of(sound, {}), factor);
        const auto path = read(upsampler, 0, 1000 * static_cast<std::size_t>(factor));
        for (std::size_t i = 0; i < 1000; ++i) {
            REQUIRE(path[i * static_cast<std::size_t>(factor)].left == sound->samples[2 * i]);
            REQUIRE(path[i * static_cast<std::size_t>(factor)].right == sound->samples[2 * i + 1]);
        }
    }
}

TEST_CASE("a 1 kHz sine is interpolated to within 1e-3") {
    for (const int factor : {2, 4, 16}) {
        const Upsampler upsampler(stream_of(circle(48000, 2000, 1000.0), {}), factor);
        const auto path = read(upsampler, 0, 2000 * static_cast<std::size_t>(factor));
        for (std::size_t i = path.size() / 20; i < path.size() * 19 / 20; ++i) {
            const double seconds = static_cast<double>(i) / (48000.0 * factor);
            REQUIRE(std::abs(path[i].left - 0.5 * sine_at(1000.0, seconds)) < 1e-3);
        }
    }
}

TEST_CASE("a constant level stays constant") {
    const auto sound = sound_of(
        44100, 500, [](int) { return 0.3; }, [](int) { return -0.7; });
    const Upsampler upsampler(stream_of(sound, {.loops = true}), 7);
    for (const StereoSample& sample : read(upsampler, 0, 3500)) {
        REQUIRE(sample.left == about(0.3, 1e-6));
        REQUIRE(sample.right == about(-0.7, 1e-6));
    }
}

TEST_CASE("a loop of whole periods is seamless") {
    const Upsampler upsampler(stream_of(circle(48000, 240, 1000.0), {.loops = true}), 4);
    const auto path = read(upsampler, -480, 3 * 960);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double seconds = (static_cast<double>(i) - 480.0) / 192000.0;
        REQUIRE(std::abs(path[i].left - 0.5 * sine_at(1000.0, seconds)) < 1e-3);
    }
}

TEST_CASE("the result does not depend on where reading starts") {
    const Upsampler upsampler(stream_of(noise_sound(700), {.first = 13, .loops = true}), 5);
    const auto whole = read(upsampler, -100, 6000);
    for (const std::size_t start : {1u, 4u, 101u, 640u, 3499u})
        CHECK(std::equal(
            whole.begin() + static_cast<std::ptrdiff_t>(start), whole.end(),
            read(upsampler, static_cast<std::int64_t>(start) - 100, 6000 - start).begin()));
}

TEST_CASE("a sound without loop is silent before its start and after its end") {
    const Upsampler upsampler(stream_of(noise_sound(50), {}), 3);
    for (const StereoSample& sample : read(upsampler, -300, 150))
        REQUIRE(sample == StereoSample{});
    for (const StereoSample& sample : read(upsampler, 250, 150))
        REQUIRE(sample == StereoSample{});
}

TEST_CASE("mono is copied to both channels, and only the first two channels are used") {
    auto mono = std::make_shared<Sound>(Sound{8000, 1, {0.25f, 0.5f}});
    CHECK(read(Upsampler(stream_of(mono, {}), 1), 1, 1).front() == StereoSample{0.5f, 0.5f});
    auto many = std::make_shared<Sound>(Sound{8000, 3, {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}});
    CHECK(read(Upsampler(stream_of(many, {}), 1), 1, 1).front() == StereoSample{0.4f, 0.5f});
}

TEST_CASE("a sound of one sample can loop") {
    auto one = std::make_shared<Sound>(Sound{8000, 1, {0.5f}});
    for (const StereoSample& sample : read(Upsampler(stream_of(one, {.loops = true}), 16), -7, 100))
        REQUIRE(sample.left == doctest::Approx(0.5));
}
