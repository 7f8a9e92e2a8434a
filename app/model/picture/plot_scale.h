#pragma once

#include <vector>

/// The range of a plot.
struct PlotRange {
    double low = 0.0;
    double high = 1.0;

    bool operator==(const PlotRange&) const = default;
    double share(double number) const { return (number - low) / (high - low); }
};

/// The next larger of 1, 1.5, 2, 3, 4, 5, 6, 8 and 10 times a power of ten; 0 for 0. Used for the
/// end of a plot, so that it does not change with each number.
double rounded_up(double number);

/// Evenly spaced numbers in a range, at most `maximum` (at least 2). Their distance is 1, 2 or 5
/// times a power of ten; 0 is included if in range.
std::vector<double> axis_ticks(const PlotRange& range, int maximum);

/// A range that grows immediately when needed, but shrinks only after a smaller range was
/// sufficient for a while. Keeps a changing plot readable.
class SteadyRange {
public:
    /// From 0 or the smallest number to the largest one, both rounded_up().
    void cover(double minimum, double greatest, double seconds);
    const PlotRange& current() const { return m_range; }

private:
    PlotRange m_range{};
    bool m_is_new = true;
    double m_needed = 0.0;  // s, when the whole range was last needed
};
