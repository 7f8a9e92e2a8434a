#include "signals/beam_sound.h"

#include "signals/points.h"

#include <cmath>

namespace {
/// The beam at one instant.
struct Instant {
    double time = 0.0;
    double x = 0.0;
    double y = 0.0;
    double current = 0.0;  // on the way to it
};

// Charge against that of full current in the same time.
double current_of(double charge, double seconds) {
    return seconds > 0.0 ? charge / (charge_of_point(1.0) * seconds) : 0.0;
}

class SoundMaker {
public:
    explicit SoundMaker(const BeamSoundFormat& format) : m_format(format) {
        m_sound.rate = format.rate;
        m_sound.channels = format.channels;
    }

    /// The next point; samples up to it are known then.
    void take(const Instant& next) {
        while (sample_time() <= next.time && m_count < count_in_all())
            write_between(m_last, next);
        m_last = next;
    }

    Sound finished() {
        while (m_count < count_in_all())
            write_between(m_last, m_last);
        return std::move(m_sound);
    }

    const Instant& last() const { return m_last; }

private:
    std::int64_t count_in_all() const { return std::llround(m_format.seconds * m_format.rate); }
    double sample_time() const { return static_cast<double>(m_count + 1) / m_format.rate; }

    void write_between(const Instant& from, const Instant& to) {
        const double span = to.time - from.time;
        const double share = span > 0.0 ? (sample_time() - from.time) / span : 1.0;
        m_sound.samples.push_back(static_cast<float>(std::lerp(from.x, to.x, share)));
        m_sound.samples.push_back(static_cast<float>(std::lerp(from.y, to.y, share)));
        if (m_format.channels > 2)
            m_sound.samples.push_back(static_cast<float>(to.current));
        ++m_count;
    }

    BeamSoundFormat m_format;
    Sound m_sound;
    Instant m_last;
    std::int64_t m_count = 0;
};
}  // namespace

Sound beam_sound(const Signal& signal, const BeamSoundFormat& format) {
    SoundMaker maker(format);
    constexpr double fps = 60.0;
    Beam beam;
    for (std::int64_t frame = 1; static_cast<double>(frame - 1) / fps < format.seconds; ++frame) {
        const TimeSpan span = frame_span(frame, fps);
        beam.clear();
        signal.trace(span, beam);
        for (const BeamPoint& point : beam) {
            const double time = span.end - static_cast<double>(point.age_seconds);
            const double seconds = time - maker.last().time;
            maker.take({time, static_cast<double>(point.x), static_cast<double>(point.y),
                        current_of(static_cast<double>(point.intensity), seconds)});
        }
    }
    return maker.finished();
}
