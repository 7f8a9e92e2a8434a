#pragma once

#include "graph/inspect/texel_reader.h"
#include "lab/window/window_state.h"
#include "model/picture/plot_scale.h"

#include <cstdint>
#include <string>
#include <vector>

/// The stored numbers along a line over a picture, looked up at most five times a second while the
/// line stays.
class Waveform {
public:
    struct Subject {
        const gpu::Texture& texture;
        std::string name;  // of what the texture holds
        ScanLine line;
        std::uint64_t picture = 0;  // Executor::picture_number
    };
    /// To be called every turn while it is shown; never waits for the GPU.
    void update(TexelReader& reader, const Subject& subject, double seconds);
    /// Nobody looks any more.
    void stop();

    /// RGBA from the line's start to its end; empty until they have come.
    const std::vector<std::array<float, 4>>& numbers() const { return m_numbers; }
    /// Over what they are plotted.
    const PlotRange& range() const { return m_range.present(); }
    /// Of what they are.
    const std::string& name() const { return m_name; }
    /// Of these, from red on, the texture has so many.
    int channels() const { return m_channels; }
    /// The texel that one of them is of, from the top left.
    std::array<int, 2> texel(std::size_t index) const;
    /// Some have not come yet.
    bool is_owing() const { return m_answer.is_busy() || m_is_late; }

private:
    void take(double seconds);

    TexelAnswer m_answer;
    std::string m_name;
    TexelRows m_rows;  // that were asked for
    TexelRows m_come;  // that the numbers are of
    std::uint64_t m_picture = 0;
    double m_due = 0.0;      // s
    bool m_is_late = false;  // they are of a former picture
    int m_channels = 4;
    std::vector<std::array<float, 4>> m_numbers;
    SteadyRange m_range;
};

double luminance_of(const std::array<float, 4>& rgba);

/// The texels along a line: as many as it is long in its longer direction, from that of its start
/// to that of its end.
TexelRows texels_along(const ScanLine& line, Extent extent);
