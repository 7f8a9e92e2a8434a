#pragma once

#include "graph/inspect/meter.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

/// What there is to tell of the inspected target's numbers. They are measured at most five times a
/// second, and where that is slow for less than a tenth of the time.
class Inspection {
public:
    explicit Inspection(std::shared_ptr<const MeterPrograms> programs)
        : m_meter(std::move(programs)) {}

    struct Subject {
        std::string pass;
        ChannelChoice channels = ChannelChoice::rgb;
        Levels levels;  // that the histogram reaches over

        bool operator==(const Subject&) const = default;
    };
    /// To be called every turn while the inspector is open; never waits for the GPU.
    void update(const gpu::Texture& target, const Subject& subject, double seconds);
    /// Nobody looks any more.
    void stop();

    /// None until they have come.
    const std::optional<Statistics>& statistics() const { return m_statistics; }
    /// From black to white; empty until it has come.
    const Histogram& histogram() const { return m_histogram; }

private:
    void take_answer(const Levels& levels);

    Meter m_meter;
    Subject m_subject;
    std::optional<Statistics> m_statistics;
    Picture m_samples;
    Histogram m_histogram;
    std::optional<double> m_due;  // s; none: at once
};
