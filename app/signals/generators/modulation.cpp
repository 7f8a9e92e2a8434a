#include "signals/generators/modulation.h"

#include "signals/generators/one_channel.h"
#include "signals/signal/sine.h"

#include <numbers>

namespace {
struct Carrier {
    explicit Carrier(const Settings& settings)
        : carrier(settings.number("carrier")),
          modulator(settings.number("modulator")),
          quarter_period(0.25 / carrier) {}

    std::vector<double> frequencies() const { return {carrier, modulator}; }

    double carrier;  // periods per 1/60 s
    double modulator;
    double quarter_period;
};

struct AmplitudeModulation : Carrier {
    explicit AmplitudeModulation(const Settings& settings)
        : Carrier(settings), depth(settings.number("depth")) {}

    double operator()(double u) const {
        return (1.0 + depth * sine(modulator * u)) / (1.0 + depth) * sine(carrier * u);
    }

    double depth;
};

struct FrequencyModulation : Carrier {
    explicit FrequencyModulation(const Settings& settings)
        : Carrier(settings), turns(settings.number("index") / (2.0 * std::numbers::pi)) {}

    double operator()(double u) const { return sine(carrier * u + turns * sine(modulator * u)); }

    double turns;
};

SettingInfo modulator_setting(double initial) {
    return periods_setting("modulator", "Modulator", "Periods of the slow wave across the screen.",
                           initial);
}

SettingInfo carrier_setting(double initial) {
    return periods_setting("carrier", "Carrier", "Periods of the fast wave across the screen.",
                           initial);
}
}  // namespace

SignalKind am_kind() {
    return {.kind = "am",
            .label = "Amplitude modulation",
            .help = "A fast sine with its amplitude modulated by a slow sine.",
            .settings = one_channel_settings({carrier_setting(24),
                                              modulator_setting(2),
                                              {.key = "depth",
                                               .label = "Depth",
                                               .help = "0: no modulation. 1: down to silence.",
                                               .initial = 0.8,
                                               .limit = {0, 1}}}),
            .make = make_one_channel<AmplitudeModulation>};
}

SignalKind fm_kind() {
    return {.kind = "fm",
            .label = "Frequency modulation",
            .help = "A fast sine with its frequency modulated by a slow sine.",
            .settings = one_channel_settings({carrier_setting(12),
                                              modulator_setting(1),
                                              {.key = "index",
                                               .label = "Modulation index",
                                               .unit = "rad",
                                               .help = "Peak deviation of the phase.",
                                               .low = 0,
                                               .high = 20,
                                               .initial = 5,
                                               .limit = {0, 1000}}}),
            .make = make_one_channel<FrequencyModulation>};
}
