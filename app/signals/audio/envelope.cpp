#include "signals/audio/envelope.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr std::int64_t stretches_in_block = 100;
constexpr double memory = 12.0;         // in time constants: older peaks contribute less than 6e-6
constexpr std::size_t max_states = 64;  // limit while the user changes a time constant

// Fraction of the difference that is covered in one stretch.
double pull_of(double time_constant) {
    return -std::expm1(-1.0 / (Envelopes::blocks_per_second * time_constant));
}
}  // namespace

double Envelopes::peak_of(std::int64_t stretch) const {
    Known& known = m_peaks[static_cast<std::size_t>(stretch) % m_peaks.size()];
    if (known.stretch != stretch)
        known = {stretch, m_peak(stretch)};
    return known.peak;
}

double Envelopes::at(double seconds, double attack, double release) const {
    const auto end = static_cast<std::int64_t>(std::floor(seconds * blocks_per_second + 1e-6));
    if (end <= 0)
        return 0.0;
    if (m_states.size() >= max_states)
        m_states.clear();
    State& state = m_states[{attack, release}];
    const std::int64_t block = (end - 1) / stretches_in_block;
    if (state.next > end || (state.next - 1) / stretches_in_block != block || state.next <= 0) {
        const double before = memory * std::max(attack, release) * blocks_per_second;
        const auto first = block * stretches_in_block - static_cast<std::int64_t>(before);
        state = {std::max<std::int64_t>(first, 0), 0.0};
    }
    const double up = pull_of(attack);
    const double down = pull_of(release);
    for (; state.next < end; ++state.next) {
        const double way = peak_of(state.next) - state.level;
        state.level += way * (way > 0.0 ? up : down);
    }
    return state.level;
}
