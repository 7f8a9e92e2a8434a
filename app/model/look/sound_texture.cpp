#include "model/look/sound_texture.h"

#include <algorithm>
#include <array>

std::string SoundTexture::name() const {
    static constexpr std::array names{"wave", "spectrum", "analyser"};
    return std::string("sound ") + names[static_cast<std::size_t>(holds)] + ' ' +
           std::to_string(columns);
}

void read_silence(const SoundTexture& texture, std::span<float> levels) {
    constexpr float no_wave = 0.5f;
    constexpr float no_tone = 0.0f;
    const std::size_t row = levels.size() / 2;
    const bool is_first_row_wave = texture.holds == SoundTexture::Holds::wave;
    const bool is_second_row_wave = texture.holds != SoundTexture::Holds::spectrum;
    std::ranges::fill(levels.first(row), is_first_row_wave ? no_wave : no_tone);
    std::ranges::fill(levels.subspan(row), is_second_row_wave ? no_wave : no_tone);
}
