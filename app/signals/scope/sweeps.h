#pragma once

#include <cstdint>
#include <optional>

/// A sweep of the beam over the samples of an input, where sample k has the instant k + 1: it
/// covers the instants (start, start + length]. Counted in samples.
struct Sweep {
    double start = 0.0;
    double length = 0.0;
    std::int64_t cut = INT64_MAX;  // no sample from here on

    std::int64_t first() const { return sample_after(start); }
    std::int64_t end() const;
    /// 0 left .. 1 right.
    double across(std::int64_t sample) const {
        return (static_cast<double>(sample + 1) - start) / length;
    }

    /// The first sample with an instant after this one; instants that differ by rounding are one.
    static std::int64_t sample_after(double instant);
};

/// When the sweeps of a scope begin; a pure function of the input.
class Sweeps {
public:
    virtual ~Sweeps() = default;
    /// The last sweep that begins at this sample or before; it may be over.
    virtual std::optional<Sweep> latest(std::int64_t sample) const = 0;
};

/// Sweeps at an even pace.
class EvenSweeps : public Sweeps {
public:
    static constexpr double once = 0.0;  // as a period: there is one sweep only

    EvenSweeps(double start, double period, double length)
        : m_start(start), m_period(period), m_length(length) {}

    std::optional<Sweep> latest(std::int64_t sample) const override;

private:
    double m_start;
    double m_period;
    double m_length;
};

/// No sweep at all.
class NoSweeps : public Sweeps {
public:
    std::optional<Sweep> latest(std::int64_t) const override { return std::nullopt; }
};
