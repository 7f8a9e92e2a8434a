#pragma once

#include "graph/executor/executor.h"
#include "graph/inspect/point_reader.h"
#include "lab/window/probes.h"

/// The values of every pass at the pinned positions, read at most five times a second.
class Pins {
public:
    static Result<Pins> make();

    /// Call it in every update while the pins are visible. Never waits for the GPU.
    void update(const Executor& executor, const std::vector<Pin>& pins, double seconds);
    /// Discards all values; call it when the pins are hidden.
    void stop();

    /// RGBA at a pin in a pass; null: still pending.
    const std::array<float, 4>* value(std::size_t pin, std::size_t pass) const;

private:
    explicit Pins(PointReader gatherer) : m_gatherer(std::move(gatherer)) {}

    PointReader m_gatherer;
    std::vector<Pin> m_pins;                     // of the last request
    std::size_t m_passes = 0;                    // of the last request
    std::vector<std::array<float, 4>> m_values;  // for each pin, pass by pass
    double m_due = 0.0;                          // s
};
