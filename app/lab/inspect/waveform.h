#pragma once

#include "graph/inspect/texel_reader.h"
#include "lab/window/probes.h"
#include "model/picture/plot_scale.h"

#include <cstdint>
#include <string>
#include <vector>

/// The stored values along a line over a picture, read at most five times a second while the line
/// does not move.
class Waveform {
public:
    struct Subject {
        const gpu::Texture& texture;
        std::string name;  // of the texture's content
        ScanLine line;
        std::uint64_t picture = 0;  // FrameTextures::number()
    };
    /// Call it in every update while it is visible. Never waits for the GPU.
    void update(TexelReader& reader, const Subject& subject, double seconds);
    /// Discards all values; call it when it is hidden.
    void stop();

    /// RGBA from the start of the line to its end; empty: still pending.
    const std::vector<std::array<float, 4>>& numbers() const { return m_numbers; }
    /// The range of the plot.
    const PlotRange& range() const { return m_range.current(); }
    /// The name of the texture's content.
    const std::string& name() const { return m_name; }
    /// The number of channels of the texture, from red.
    int channels() const { return m_channels; }
    /// The texel of a value, from the top left.
    std::array<int, 2> texel(std::size_t index) const;
    /// Whether values are still pending.
    bool is_pending() const { return m_readback.is_busy() || m_is_late; }

private:
    void take(double seconds);

    TexelReadback m_readback;
    std::string m_name;
    TexelRows m_rows;  // of the last request
    TexelRows m_come;  // of the current values
    std::uint64_t m_picture = 0;
    double m_due = 0.0;      // s
    bool m_is_late = false;  // the values are of a previous picture
    int m_channels = 4;
    std::vector<std::array<float, 4>> m_numbers;
    SteadyRange m_range;
};

double luminance_of(const std::array<float, 4>& rgba);

/// The texels along a line, from that of its start to that of its end. Their number is the length
/// of the line in its longer direction.
TexelRows texels_along(const ScanLine& line, Extent extent);
