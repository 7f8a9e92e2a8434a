#include "lab/inspect/waveform.h"

#include "model/look/format.h"

#include <algorithm>
#include <cmath>

double luminance_of(const std::array<float, 4>& rgba) {
    return 0.2126 * rgba[0] + 0.7152 * rgba[1] + 0.0722 * rgba[2];  // ITU-R BT.709
}

TexelRows texels_along(const ScanLine& line, Extent extent) {
    const auto start = line.start.texel(extent);
    const auto end = line.end.texel(extent);
    const int width = end[0] - start[0];
    const int height = end[1] - start[1];
    const int steps = std::max(std::abs(width), std::abs(height));
    const double parts = std::max(steps, 1);
    return {.count = {steps + 1, 1},
            .first = {start[0] + 0.5, start[1] + 0.5},
            .across = {width / parts, height / parts}};
}

void Waveform::stop() {
    m_readback.stop();
    m_name.clear();
    m_numbers.clear();
    m_rows = {};
    m_range = {};
    m_is_late = false;
}

std::array<int, 2> Waveform::texel(std::size_t index) const {
    const auto at = static_cast<double>(index);
    return {static_cast<int>(m_come.first[0] + at * m_come.across[0]),
            static_cast<int>(m_come.first[1] + at * m_come.across[1])};
}

void Waveform::take(double seconds) {
    auto numbers = m_readback.take();
    if (!numbers)
        return;
    m_numbers = std::move(*numbers);
    m_come = m_rows;
    double minimum = 0.0;
    double greatest = 0.0;
    const int plotted_channels = std::min(m_channels, 3);
    for (const auto& rgba : m_numbers)
        for (int i = 0; i < plotted_channels; ++i) {
            const double number = rgba[static_cast<std::size_t>(i)];
            if (!std::isfinite(number))
                continue;
            minimum = std::min(minimum, number);
            greatest = std::max(greatest, number);
        }
    m_range.cover(minimum, greatest, seconds);
}

void Waveform::update(TexelReader& reader, const Subject& subject, double seconds) {
    constexpr double pause_seconds = 0.2;
    if (subject.name != m_name) {
        stop();  // discard numbers of another texture
        m_name = subject.name;
    }
    take(seconds);
    const TexelRows rows = texels_along(subject.line, subject.texture.extent());
    const bool is_moved = rows != m_rows;
    m_is_late = is_moved || m_picture != subject.picture;
    if (m_readback.is_busy() || !m_is_late || (!is_moved && seconds < m_due))
        return;
    m_channels = info_of(subject.texture.format()).channels;
    m_readback.ask(reader, subject.texture, rows);
    m_rows = rows;
    m_picture = subject.picture;
    m_due = seconds + pause_seconds;
    m_is_late = false;
}
