#pragma once

#include "portable_player/description.h"

#include <memory>
#include <vector>

/// A position of the beam. It has moved there at constant speed from the previous point.
struct BeamPoint {
    double time = 0.0;  // s
    double x = 0.0;     // -1 to 1
    double y = 0.0;
    double charge = 0.0;  // 1: full current for 1/4096 of 1/60 s
};

class Signal {
public:
    virtual ~Signal() = default;
    /// Appends the points with start < time <= end.
    virtual void trace(double start, double end, std::vector<BeamPoint>& points) const = 0;
};

/// The member `signal` of a look. Fails for sounds and beams of other programs.
std::unique_ptr<Signal> make_signal(const Json& signal);

// The signals by kind.
std::unique_ptr<Signal> make_lissajous(const Json& settings);
std::unique_ptr<Signal> make_harmonics(const Json& settings);
std::unique_ptr<Signal> make_am(const Json& settings);
std::unique_ptr<Signal> make_fm(const Json& settings);
std::unique_ptr<Signal> make_waveform(const Json& settings);
std::unique_ptr<Signal> make_scene(const Json& paths, double points_per_second);
std::unique_ptr<Signal> make_drawing(const Json& paths, double points_per_second);

/// The numbers k from 0 of the instants (k + 1) / rate in start < time <= end.
struct Instants {
    long first = 0;
    long end = 0;
};
Instants instants_in(double start, double end, double rate);

constexpr double full_charge_rate = 4096.0 * 60.0;  // points per second with a charge of 1
