#include "lab/playback/live_input.h"

#include <cmath>

Result<void> LiveInput::open(const AudioDevices& devices, int channels, double time) {
    if (m_capture && channels <= m_channels)
        return {};
    if (!m_is_muted) {
        auto capture = devices.open_capture(channels);
        if (!capture)
            return fail(capture.error());
        m_capture = std::move(*capture);
        start_at(time);
    }
    m_channels = channels;
    return {};
}

void LiveInput::set_muted(bool is_muted) {
    m_is_muted = is_muted;
    if (!is_muted)
        return;
    close();
    m_first_frame = 0;
}

void LiveInput::start_at(double time) {
    const double ahead = m_capture->position_seconds() - time;
    m_first_frame = std::llround(ahead * m_capture->sound()->rate());
}

std::shared_ptr<const LiveSound> LiveInput::sound() const {
    if (m_capture)
        return m_capture->sound();
    return std::make_shared<const LiveSound>(48000, m_channels);
}

double LiveInput::end_seconds() const {
    const double start = static_cast<double>(m_first_frame) / m_capture->sound()->rate();
    return m_capture->position_seconds() - start;
}
