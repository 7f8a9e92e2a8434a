#pragma once

#include "signals/audio/sample_stream.h"
#include "signals/signal/signal.h"

#include <map>
#include <vector>

/// A beam as an audio stream: left is x, right is y, at 48 kHz, like beam_sound().
class BeamStream : public SampleStream {
public:
    explicit BeamStream(std::shared_ptr<const Signal> signal) : m_signal(std::move(signal)) {}

    int rate() const override { return samples_per_second; }
    std::int64_t length() const override { return endless; }
    bool loops() const override { return false; }
    bool is_live() const override { return false; }
    void read(std::int64_t first, std::span<StereoSample> samples) const override;

private:
    static constexpr int samples_per_second = 48000;
    static constexpr std::int64_t blocks_per_second = 60;
    static constexpr std::int64_t samples_per_block = samples_per_second / blocks_per_second;

    const std::vector<float>& block(std::int64_t number) const;

    std::shared_ptr<const Signal> m_signal;  // shared with the renderer
    mutable std::map<std::int64_t, std::vector<float>> m_blocks;
};
