#pragma once

#include <deque>
#include <optional>

/// The tempo of taps on a key.
class TapTempo {
public:
    /// A tap at a time that only rises, in seconds. Returns the tempo in beats per minute, from the
    /// median of the last eight intervals; nullopt: after the first tap, or if it is out of range.
    /// After a pause of two seconds, a new series begins.
    std::optional<double> tap(double seconds);
    /// Taps in the current series.
    std::size_t count() const { return m_taps.size(); }

private:
    std::deque<double> m_taps;  // s
};
