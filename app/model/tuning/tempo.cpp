#include "model/tuning/tempo.h"

#include <algorithm>
#include <cmath>

Tempo with_bpm(const Tempo& tempo, double bpm, double seconds) {
    Tempo next = tempo;
    next.bpm = bpm;
    next = normalised(next);
    next.downbeat = seconds - tempo.beats_at(seconds) * next.seconds_per_beat();
    return next;
}

Tempo with_downbeat(const Tempo& tempo, double seconds) {
    Tempo next = tempo;
    next.downbeat = seconds;
    return next;
}

Tempo normalised(const Tempo& tempo) {
    const Tempo usual;
    constexpr double longest = 1e6;  // s
    const auto bounded = [](double value, double low, double high, double fallback) {
        return std::isfinite(value) ? std::clamp(value, low, high) : fallback;
    };
    return {bounded(tempo.bpm, min_bpm, max_bpm, usual.bpm),
            bounded(tempo.downbeat, -longest, longest, usual.downbeat),
            std::round(bounded(tempo.beats_per_bar, 1.0, max_beats_per_bar, usual.beats_per_bar))};
}
