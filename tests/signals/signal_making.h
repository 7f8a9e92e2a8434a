#pragma once

#include "signals/signal_table.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>

/// The signal of a spec. The test fails when it is rejected.
inline std::unique_ptr<Signal> signal_of(std::string_view text,
                                         std::shared_ptr<const Sound> sound = nullptr) {
    auto signal = make_signal(parse_spec(text).value(), {std::move(sound)});
    if (!signal)
        FAIL(to_string(signal.error()));
    return std::move(*signal);
}

inline Beam beam_of(const Signal& signal, const TimeSpan& span) {
    Beam beam;
    signal.trace(span, beam);
    return beam;
}

inline double charge_of(const Beam& beam) {
    double sum = 0.0;
    for (const BeamPoint& point : beam)
        sum += static_cast<double>(point.intensity);
    return sum;
}

/// A sound whose left and right channels are functions of the sample number.
template <class Left, class Right>
std::shared_ptr<const Sound> sound_of(int rate, int frames, const Left& left, const Right& right) {
    auto sound = std::make_shared<Sound>();
    sound->rate = rate;
    sound->channels = 2;
    for (int i = 0; i < frames; ++i) {
        sound->samples.push_back(static_cast<float>(left(i)));
        sound->samples.push_back(static_cast<float>(right(i)));
    }
    return sound;
}

inline double sine_at(double hertz, double seconds) {
    return std::sin(2.0 * std::numbers::pi * hertz * seconds);
}

/// A sine on the left and, a quarter period ahead, on the right.
inline std::shared_ptr<const Sound> circle(int rate, int frames, double hertz) {
    return sound_of(
        rate, frames, [=](int i) { return 0.5 * sine_at(hertz, static_cast<double>(i) / rate); },
        [=](int i) { return 0.5 * sine_at(hertz, static_cast<double>(i) / rate + 0.25 / hertz); });
}
