#pragma once

#include "graph/inspect/meter.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

/// Statistics and histogram of the inspected target. Measured at most five times a second, and for
/// at most a tenth of the time.
class Inspection {
public:
    explicit Inspection(std::shared_ptr<const MeterPrograms> programs)
        : m_meter(std::move(programs)) {}

    struct Subject {
        std::string pass;
        Channels channels = Channels::color;
        Levels levels;  // range of the histogram

        bool operator==(const Subject&) const = default;
    };
    /// Call it in every update while the inspector is open. Never waits for the GPU.
    void update(const gpu::Texture& target, const Subject& subject, double seconds);
    /// Discards all results; call it when the inspector is closed.
    void stop();

    /// nullopt: still pending.
    const std::optional<Statistics>& statistics() const { return m_statistics; }
    /// From black to white; empty: still pending.
    const Histogram& histogram() const { return m_histogram; }

private:
    void take_answer(const Levels& levels);

    Meter m_meter;
    Subject m_subject;
    std::optional<Statistics> m_statistics;
    Picture m_samples;
    Histogram m_histogram;
    std::optional<double> m_due;  // s; nullopt: immediately
};
