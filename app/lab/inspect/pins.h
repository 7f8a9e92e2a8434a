#pragma once

#include "graph/executor/executor.h"
#include "graph/inspect/gatherer.h"
#include "lab/window/window_state.h"

/// The numbers that every pass has at the pinned points, looked up at most five times a second.
class Pins {
public:
    static Result<Pins> make();

    /// To be called every turn while the pins are shown; never waits for the GPU.
    void update(const Executor& executor, const std::vector<Pin>& pins, double seconds);
    /// Nobody looks any more.
    void stop();

    /// RGBA at a pin in a pass; null until it has come.
    const std::array<float, 4>* value(std::size_t pin, std::size_t pass) const;

private:
    explicit Pins(Gatherer gatherer) : m_gatherer(std::move(gatherer)) {}

    Gatherer m_gatherer;
    std::vector<Pin> m_pins;                     // that were asked for
    std::size_t m_passes = 0;                    // the same
    std::vector<std::array<float, 4>> m_values;  // pass by pass of each pin
    double m_due = 0.0;                          // s
};
