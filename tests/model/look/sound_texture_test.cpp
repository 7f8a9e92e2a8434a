#include "model/look/sound_texture.h"

#include <doctest/doctest.h>

#include <vector>

TEST_CASE("silence is 0.5 in a waveform and 0 in a spectrum") {
    using Holds = SoundTexture::Holds;
    std::vector<float> levels(6);
    read_silence({Holds::wave, 3}, levels);
    CHECK(levels == std::vector<float>{0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f});
    read_silence({Holds::spectrum, 3}, levels);
    CHECK(levels == std::vector<float>(6, 0.0f));
    read_silence({Holds::analyser, 3}, levels);
    CHECK(levels == std::vector<float>{0.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.5f});
}
