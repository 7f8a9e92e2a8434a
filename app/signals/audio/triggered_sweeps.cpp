#include "signals/audio/triggered_sweeps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {
constexpr double timeout_seconds = 0.1;
constexpr double min_epoch_seconds = 4.0;
constexpr double sweeps_per_epoch = 16.0;
}  // namespace

TriggeredSweeps::TriggeredSweeps(const SoundInput& input, const Trigger& trigger,
                                 std::size_t channel, bool is_inverted, double length)
    : m_input(input),
      m_trigger(trigger),
      m_channel(channel),
      m_sign(is_inverted ? -1.0f : 1.0f),
      m_length(length),
      m_busy(length + trigger.holdoff_seconds * input.rate()),
      m_timeout(timeout_seconds * input.rate()),
      m_epoch_length(std::numeric_limits<std::int64_t>::max() / 64) {
    if (trigger.mode == Trigger::Mode::single)
        return;  // one search from time 0
    const double epoch = std::max(min_epoch_seconds * input.rate(), sweeps_per_epoch * m_busy);
    m_epoch_length = static_cast<std::int64_t>(std::ceil(epoch / input.factor()));
}

// Starts earlier by m_timeout, to find out whether the sound fires the trigger at all.
void TriggeredSweeps::begin(std::int64_t epoch) const {
    const auto factor = static_cast<double>(m_input.factor());
    const std::int64_t first = epoch * m_epoch_length;
    m_epoch = epoch;
    m_next = first - static_cast<std::int64_t>(std::ceil(m_timeout / factor));
    m_ready = static_cast<double>(first) * factor;
    m_event = -std::numeric_limits<double>::infinity();
    m_last = 0.0f;
    m_starts.clear();
}

void TriggeredSweeps::sweep_from(double instant) const {
    m_starts.push_back(instant);
    m_ready = instant + m_busy;
    if (m_trigger.mode == Trigger::Mode::single)
        m_ready = std::numeric_limits<double>::infinity();
}

void TriggeredSweeps::begin_unasked(double now) const {
    if (m_trigger.mode != Trigger::Mode::automatic)
        return;
    for (double at = std::max(m_ready, m_event + m_timeout); at <= now;
         at = std::max(m_ready, m_event + m_timeout))
        sweep_from(at);
}

// `level` is the next sample relative to the trigger level. The crossing is interpolated linearly
// between samples.
void TriggeredSweeps::follow(float level) const {
    const auto factor = static_cast<double>(m_input.factor());
    const double now = static_cast<double>(m_next) * factor + 1.0;
    if (m_last < 0.0f && level >= 0.0f) {
        const double crossing = now - factor * level / (level - m_last);
        begin_unasked(crossing);
        m_event = crossing;
        if (crossing >= m_ready)
            sweep_from(crossing);
    }
    begin_unasked(now);
    m_last = level;
    ++m_next;
}

void TriggeredSweeps::find_up_to(std::int64_t sample) const {
    std::array<StereoSample, 64> volts;
    const auto level = static_cast<float>(m_trigger.level);
    const float slope = m_trigger.is_rising ? 1.0f : -1.0f;
    if (std::isinf(m_ready))
        return;  // the single sweep was found
    while ((m_next - 1) * m_input.factor() <= sample) {
        m_input.read_originals(m_next, volts);
        for (const StereoSample& both : volts)
            follow(slope * (m_sign * (m_channel == 0 ? both.left : both.right) - level));
    }
}

std::optional<Sweep> TriggeredSweeps::latest(std::int64_t sample) const {
    const std::int64_t factor = m_input.factor();
    const std::int64_t epoch = sample / factor / m_epoch_length;
    if (epoch != m_epoch)
        begin(epoch);
    find_up_to(sample);
    const auto after = std::upper_bound(
        m_starts.begin(), m_starts.end(), sample,
        [](std::int64_t known, double start) { return known < Sweep::sample_after(start); });
    if (after == m_starts.begin())
        return std::nullopt;
    return Sweep{.start = *std::prev(after),
                 .length = m_length,
                 .cut = (epoch + 1) * m_epoch_length * factor};
}
