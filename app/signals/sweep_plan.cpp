#include "signals/sweep_plan.h"

#include <algorithm>
#include <cmath>

SweepPlan SweepPlan::triggered(const Upsampler& sound, std::int64_t length, std::int64_t patience,
                               const std::function<float(StereoSample)>& level) {
    SweepPlan plan(length);
    plan.m_period = sound.length() * sound.factor();
    std::int64_t ready = 0;  // the first up-sampled sample that a sweep may begin with
    const auto sweep_from = [&](std::int64_t start) {
        plan.m_starts.push_back(start);
        ready = start + length;
    };
    float last = level(sound.original(0));
    for (std::int64_t i = 1; i < sound.length(); ++i) {
        const float next = level(sound.original(i));
        while ((i - patience) * sound.factor() >= ready)
            sweep_from(ready);
        if (last < 0.0f && next >= 0.0f) {
            const double crossing = static_cast<double>(i - 1) + last / (last - next);
            const auto start = static_cast<std::int64_t>(std::ceil(crossing * sound.factor()));
            if (start >= ready)
                sweep_from(start);
        }
        last = next;
    }
    // What is left is shorter than the patience: it is drawn rather than waited through.
    while (ready < plan.m_period)
        sweep_from(ready);
    return plan;
}

SweepPlace SweepPlan::place_of(std::int64_t sample, std::size_t& hint) const {
    if (m_period == 0)
        return {sample % m_length, false};
    const std::int64_t place = sample % m_period;
    if (hint >= m_starts.size() || m_starts[hint] > place) {
        const auto after = std::upper_bound(m_starts.begin(), m_starts.end(), place);
        hint = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - m_starts.begin() - 1, 0));
    }
    while (hint + 1 < m_starts.size() && m_starts[hint + 1] <= place)
        ++hint;
    const std::int64_t within = place - m_starts[hint];
    return {within, within < 0 || within >= m_length};
}
