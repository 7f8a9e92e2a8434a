#include "signals/generators/harmonics.h"

#include "signals/generators/one_channel.h"
#include "signals/signal/sine.h"

#include <cmath>

namespace {
// Amplitude of the n-th harmonic: all (saw), odd only (square), odd only with alternating signs
// (triangle).
double strength(std::string_view shape, int n, double falloff) {
    const double size = std::pow(n, -falloff);
    if (shape == "saw")
        return size;
    if (n % 2 == 0)
        return 0.0;
    return shape == "triangle" && n % 4 == 3 ? -size : size;
}

// One period of the sum, normalised to a peak of 1, with linear interpolation. With 64 harmonics
// the interpolation error is at most (2 pi 64 / 32768)^2 / 8 = 2e-5.
class Harmonics {
public:
    explicit Harmonics(const Settings& settings)
        : quarter_period(0.25 / settings.number("base")),
          m_base(settings.number("base")),
          m_table(entries + 1, 0.0) {
        for (int n = 1; n <= settings.whole("count"); ++n)
            add(n, strength(settings.word("shape"), n, settings.number("falloff")));
        double peak = 0.0;
        for (const double value : m_table)
            peak = std::max(peak, std::abs(value));
        for (double& value : m_table)
            value /= peak;
    }

    double operator()(double u) const {
        const double position = fraction(m_base * u) * entries;
        const auto below = static_cast<std::size_t>(position);
        return std::lerp(m_table[below], m_table[below + 1], position - static_cast<double>(below));
    }

    std::vector<double> frequencies() const { return {m_base}; }

    double quarter_period;

private:
    void add(int n, double size) {
        for (std::size_t i = 0; i < m_table.size(); ++i)
            m_table[i] += size * sine(static_cast<double>(i) * n / entries);
    }

    static constexpr int entries = 32768;
    double m_base;
    std::vector<double> m_table;  // one period, then its first entry again
};
}  // namespace

SignalKind harmonics_kind() {
    return {.kind = "harmonics",
            .label = "Harmonics",
            .help = "A sum of sines at multiples of a base frequency.",
            .settings = one_channel_settings(
                {periods_setting("base", "Base frequency",
                                 "Periods of the lowest sine across the screen.", 2),
                 {.key = "count",
                  .label = "Harmonics",
                  .help = "Highest multiple of the base frequency.",
                  .low = 1,
                  .high = 32,
                  .step = 1,
                  .initial = 5,
                  .limit = {1, 64}},
                 {.key = "falloff",
                  .label = "Fall-off",
                  .help = "The n-th sine has 1 / n^falloff of the first sine's amplitude.",
                  .low = 0,
                  .high = 3,
                  .initial = 1,
                  .limit = {0, 10}},
                 {.key = "shape",
                  .label = "Shape",
                  .help = "saw: all multiples. square: odd multiples. triangle: odd multiples with "
                          "alternating sign (use fall-off 2).",
                  .type = SettingType::word,
                  .words = {"saw", "square", "triangle"},
                  .initial_word = "saw"}}),
            .make = make_one_channel<Harmonics>};
}
