#include "signals/sample_stream.h"

#include <algorithm>
#include <array>

namespace {
class SoundStream : public SampleStream {
public:
    SoundStream(std::shared_ptr<const Sound> sound, const SoundPart& part)
        : m_sound(std::move(sound)),
          m_part(part),
          m_length(static_cast<std::int64_t>(m_sound->frame_count()) - part.first) {}

    int rate() const override { return m_sound->rate; }
    std::int64_t length() const override { return m_length; }
    bool loops() const override { return m_part.loops; }
    bool is_live() const override { return false; }

    void read(std::int64_t first, std::span<StereoSample> samples) const override {
        for (StereoSample& sample : samples)
            sample = at(first++);
    }

private:
    StereoSample at(std::int64_t place) const {
        if (place < 0 || place >= m_length) {
            if (!m_part.loops)
                return {};
            place = ((place % m_length) + m_length) % m_length;
        }
        const auto channels = static_cast<std::size_t>(m_sound->channels);
        const float* frame =
            m_sound->samples.data() + static_cast<std::size_t>(m_part.first + place) * channels;
        return {frame[0], channels > 1 ? frame[1] : frame[0]};
    }

    std::shared_ptr<const Sound> m_sound;  // shared with the signal's owner and the sound device
    SoundPart m_part;
    std::int64_t m_length;
};

class LiveStream : public SampleStream {
public:
    LiveStream(std::shared_ptr<const LiveSound> sound, std::int64_t first)
        : m_sound(std::move(sound)), m_first(first) {}

    int rate() const override { return m_sound->rate(); }
    std::int64_t length() const override { return endless; }
    bool loops() const override { return false; }
    bool is_live() const override { return true; }

    void read(std::int64_t first, std::span<StereoSample> samples) const override {
        std::array<float, 512> stereo;
        for (std::size_t done = 0; done < samples.size();) {
            const std::size_t count = std::min(samples.size() - done, stereo.size() / 2);
            m_sound->read(m_first + first + static_cast<std::int64_t>(done),
                          std::span(stereo).first(2 * count));
            for (std::size_t i = 0; i < count; ++i)
                samples[done + i] = {stereo[2 * i], stereo[2 * i + 1]};
            done += count;
        }
    }

private:
    std::shared_ptr<const LiveSound> m_sound;  // shared with the device's thread, which writes it
    std::int64_t m_first;
};
}  // namespace

std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const Sound> sound,
                                              const SoundPart& part) {
    return std::make_shared<SoundStream>(std::move(sound), part);
}

std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const LiveSound> sound,
                                              std::int64_t first) {
    return std::make_shared<LiveStream>(std::move(sound), first);
}
