#pragma once

#include <cstdint>
#include <optional>

/// A sweep of the beam over input samples, counted in samples. Sample k has the instant k + 1. The
/// sweep covers the instants (start, start + length].
struct Sweep {
    double start = 0.0;
    double length = 0.0;
    std::int64_t cut = INT64_MAX;  // no samples from here on

    std::int64_t first() const { return sample_after(start); }
    std::int64_t end() const;
    /// 0 left .. 1 right.
    double across(std::int64_t sample) const {
        return (static_cast<double>(sample + 1) - start) / length;
    }

    /// The first sample with an instant after this one, apart from rounding errors.
    static std::int64_t sample_after(double instant);
};

/// The start times of a scope's sweeps; a pure function of the input.
class Sweeps {
public:
    virtual ~Sweeps() = default;
    /// The last sweep that starts at or before this sample; it may have ended.
    virtual std::optional<Sweep> latest(std::int64_t sample) const = 0;
    /// Samples from one start to the next; 0: not constant, or never.
    virtual double period() const { return 0.0; }
};

/// Sweeps with a constant period.
class PeriodicSweeps : public Sweeps {
public:
    static constexpr double once = 0.0;  // as a period: a single sweep

    PeriodicSweeps(double start, double period, double length)
        : m_start(start), m_period(period), m_length(length) {}

    std::optional<Sweep> latest(std::int64_t sample) const override;
    double period() const override { return m_period; }

private:
    double m_start;
    double m_period;
    double m_length;
};

/// Never sweeps.
class NoSweeps : public Sweeps {
public:
    std::optional<Sweep> latest(std::int64_t) const override { return std::nullopt; }
};
