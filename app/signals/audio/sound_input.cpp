#include "signals/audio/sound_input.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
constexpr double coupling_hertz = 5.0;  // scope inputs: 10 Hz or less
}  // namespace

SoundInput::SoundInput(std::shared_ptr<const SampleStream> sound, const SoundInputSettings& plug)
    : m_plug(plug),
      m_samples(std::move(sound), plug.upsample),
      m_rate(static_cast<double>(m_samples.sound().rate()) * plug.upsample),
      m_is_ac(plug.coupling[0] == Coupling::ac || plug.coupling[1] == Coupling::ac),
      m_slow(low_pass()),
      m_slow_originals(low_pass()) {
    if (plug.has_auto_gain)
        m_gain.emplace(m_samples.sound());
}

LowPass SoundInput::low_pass() const {
    return LowPass(m_samples.sound().rate(), coupling_hertz,
                   [this](std::int64_t first, std::span<StereoSample> samples) {
                       read_routed(first, samples);
                   });
}

std::int64_t SoundInput::count() const {
    const SampleStream& sound = m_samples.sound();
    return sound.loops() ? SampleStream::endless * factor() : sound.length() * factor();
}

double SoundInput::seconds() const {
    const SampleStream& sound = m_samples.sound();
    if (sound.loops() || sound.is_live())
        return std::numeric_limits<double>::infinity();
    return static_cast<double>(sound.length()) / sound.rate();
}

StereoSample SoundInput::routed(StereoSample sample) const {
    if (m_plug.channels == SoundChannels::mean)
        sample.left = 0.5f * (sample.left + sample.right);
    return m_plug.is_swapped ? StereoSample{sample.right, sample.left} : sample;
}

void SoundInput::read_routed(std::int64_t first, std::span<StereoSample> samples) const {
    m_samples.sound().read(first, samples);
    for (StereoSample& sample : samples)
        sample = routed(sample);
}

float SoundInput::gain_at(double position) const {
    const auto level = static_cast<float>(m_plug.level);
    return m_gain ? level * m_gain->at(position) : level;
}

void SoundInput::couple(StereoSample& sample, StereoSample slow) const {
    const auto coupled = [](Coupling coupling, float volts, float slow_volts) {
        if (coupling == Coupling::ground)
            return 0.0f;
        return coupling == Coupling::ac ? volts - slow_volts : volts;
    };
    sample = {coupled(m_plug.coupling[0], sample.left, slow.left),
              coupled(m_plug.coupling[1], sample.right, slow.right)};
}

void SoundInput::read(std::int64_t first, std::span<StereoSample> volts) const {
    m_samples.read(first, volts);
    const std::int64_t factor = m_samples.factor();
    std::vector<StereoSample> slow;
    const std::int64_t first_original = first / factor;
    if (m_is_ac) {
        const std::int64_t last = (first + static_cast<std::int64_t>(volts.size())) / factor + 1;
        slow.resize(static_cast<std::size_t>(last - first_original + 1));
        m_slow.read(first_original, slow);
    }
    for (StereoSample& sample : volts) {
        const std::int64_t original = first / factor;
        const double between = static_cast<double>(first % factor) / static_cast<double>(factor);
        StereoSample away;
        if (m_is_ac) {
            const auto at = static_cast<std::size_t>(original - first_original);
            const auto part = static_cast<float>(between);
            away = {std::lerp(slow[at].left, slow[at + 1].left, part),
                    std::lerp(slow[at].right, slow[at + 1].right, part)};
        }
        sample = routed(sample);
        couple(sample, away);
        const float gain =
            gain_at(static_cast<double>(original % m_samples.sound().length()) + between);
        sample = {sample.left * gain, sample.right * gain};
        ++first;
    }
}

void SoundInput::read_originals(std::int64_t first, std::span<StereoSample> volts) const {
    std::vector<StereoSample> slow;
    if (m_is_ac) {
        slow.resize(volts.size());
        m_slow_originals.read(first, slow);
    }
    read_routed(first, volts);
    const std::int64_t length = m_samples.sound().length();
    for (std::size_t i = 0; i < volts.size(); ++i, ++first) {
        couple(volts[i], m_is_ac ? slow[i] : StereoSample{});
        const float gain = gain_at(static_cast<double>(((first % length) + length) % length));
        volts[i] = {volts[i].left * gain, volts[i].right * gain};
    }
}

StereoSample SoundReader::at(std::int64_t sample) {
    if (sample < m_first || sample >= m_filled) {
        const auto count = std::min(m_end - sample, static_cast<std::int64_t>(m_block.size()));
        m_input.read(sample, std::span(m_block).first(static_cast<std::size_t>(count)));
        m_first = sample;
        m_filled = sample + count;
    }
    return m_block[static_cast<std::size_t>(sample - m_first)];
}
