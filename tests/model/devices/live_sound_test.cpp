#include "model/devices/live_sound.h"

#include <doctest/doctest.h>

namespace {
std::vector<float> read(const LiveSound& sound, std::int64_t first, std::size_t frames) {
    std::vector<float> stereo(2 * frames);
    sound.read(first, stereo);
    return stereo;
}
}  // namespace

TEST_CASE("written samples are read back by frame number, with silence before and after") {
    LiveSound sound(1000);
    sound.write(std::vector<float>{0.1f, 0.2f, 0.3f, 0.4f}, 2);
    CHECK(sound.frame_count() == 2);
    CHECK(read(sound, -1, 4) == std::vector<float>{0.0f, 0.0f, 0.1f, 0.2f, 0.3f, 0.4f, 0.0f, 0.0f});
}

TEST_CASE("mono is copied to both channels, and of six channels the first two are kept") {
    LiveSound sound(1000);
    sound.write(std::vector<float>{0.5f}, 1);
    sound.write(std::vector<float>{1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}, 6);
    CHECK(read(sound, 0, 2) == std::vector<float>{0.5f, 0.5f, 1.0f, 2.0f});
}

TEST_CASE("only the most recent seconds of live sound are kept") {
    LiveSound sound(100);
    std::vector<float> frame(2);
    for (int i = 0; i < 10000; ++i) {
        frame[0] = frame[1] = static_cast<float>(i);
        sound.write(frame, 2);
    }
    CHECK(sound.seconds() == 100.0);
    CHECK(read(sound, 100, 1).front() == 0.0f);
    CHECK(read(sound, 9000, 1).front() == 9000.0f);
    CHECK(read(sound, 9999, 1).front() == 9999.0f);
}

TEST_CASE("more than two channels are kept on request") {
    LiveSound sound(1000, 5);
    CHECK(sound.channels() == 5);
    sound.write(std::vector<float>{1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}, 6);
    sound.write(std::vector<float>{7.0f, 8.0f}, 2);
    std::vector<float> read(10);
    sound.read(0, read);
    CHECK(read == std::vector<float>{1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 7.0f, 8.0f, 8.0f, 8.0f, 8.0f});
}
