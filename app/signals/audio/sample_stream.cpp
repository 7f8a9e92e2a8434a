#include "signals/audio/sample_stream.h"

#include <algorithm>
#include <array>

namespace {
/// Selects left and right in a frame of several channels.
class Picker {
public:
    Picker(const StreamChannels& channels, int count)
        : m_left(std::min(channels.left, count)), m_right(std::min(channels.right, count)) {}

    StereoSample from(const float* frame) const {
        return {m_left > 0 ? frame[m_left - 1] : 0.0f, m_right > 0 ? frame[m_right - 1] : 0.0f};
    }

private:
    int m_left;
    int m_right;
};

class SoundStream : public SampleStream {
public:
    SoundStream(std::shared_ptr<const Sound> sound, const SoundPart& part,
                const StreamChannels& channels)
        : m_sound(std::move(sound)),
          m_part(part),
          m_picker(channels, m_sound->channels),
          m_length(part.length_in(static_cast<std::int64_t>(m_sound->frame_count()))) {}

    int rate() const override { return m_sound->rate; }
    std::int64_t length() const override { return m_length; }
    bool loops() const override { return m_part.loops; }
    bool is_live() const override { return false; }

    void read(std::int64_t first, std::span<StereoSample> samples) const override {
        for (StereoSample& sample : samples)
            sample = at(first++);
    }

private:
    StereoSample at(std::int64_t index) const {
        if (index < 0 || index >= m_length) {
            if (!m_part.loops)
                return {};
            index = ((index % m_length) + m_length) % m_length;
        }
        const auto channels = static_cast<std::size_t>(m_sound->channels);
        const float* frame =
            m_sound->samples.data() + static_cast<std::size_t>(m_part.first + index) * channels;
        return m_picker.from(frame);
    }

    std::shared_ptr<const Sound> m_sound;  // shared with the signal's owner and the audio device
    SoundPart m_part;
    Picker m_picker;
    std::int64_t m_length;
};

class LiveStream : public SampleStream {
public:
    LiveStream(std::shared_ptr<const LiveSound> sound, std::int64_t first,
               const StreamChannels& channels)
        : m_sound(std::move(sound)), m_first(first), m_picker(channels, m_sound->channels()) {}

    int rate() const override { return m_sound->rate(); }
    std::int64_t length() const override { return endless; }
    bool loops() const override { return false; }
    bool is_live() const override { return true; }

    void read(std::int64_t first, std::span<StereoSample> samples) const override {
        std::array<float, 1024> block;
        const auto channels = static_cast<std::size_t>(m_sound->channels());
        for (std::size_t done = 0; done < samples.size();) {
            const std::size_t count = std::min(samples.size() - done, block.size() / channels);
            m_sound->read(m_first + first + static_cast<std::int64_t>(done),
                          std::span(block).first(count * channels));
            for (std::size_t i = 0; i < count; ++i)
                samples[done + i] = m_picker.from(block.data() + i * channels);
            done += count;
        }
    }

private:
    std::shared_ptr<const LiveSound> m_sound;  // shared with the audio device thread, which writes
                                               // it
    std::int64_t m_first;
    Picker m_picker;
};
}  // namespace

std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const Sound> sound,
                                              const SoundPart& part,
                                              const StreamChannels& channels) {
    return std::make_shared<SoundStream>(std::move(sound), part, channels);
}

std::shared_ptr<const SampleStream> stream_of(std::shared_ptr<const LiveSound> sound,
                                              std::int64_t first, const StreamChannels& channels) {
    return std::make_shared<LiveStream>(std::move(sound), first, channels);
}
