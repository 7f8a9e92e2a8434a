#pragma once

#include <vector>

/// What a plot of numbers reaches over.
struct PlotRange {
    double low = 0.0;
    double high = 1.0;

    bool operator==(const PlotRange&) const = default;
    double share(double number) const { return (number - low) / (high - low); }
};

/// The next larger of 1, 1.5, 2, 3, 4, 5, 6, 8 and 10 times a power of ten: an end for a plot that
/// does not move with each number. 0 for 0.
double rounded_up(double number);

/// Even numbers within a range, at most so many (at least 2): each 1, 2 or 5 times a power of ten
/// further than the one before, with 0 among them where it lies within.
std::vector<double> even_numbers(const PlotRange& range, int most);

/// A range that grows as soon as numbers need it, and shrinks only when they have needed less for a
/// while: a plot that stays readable while they move.
class SteadyRange {
public:
    /// From 0 or the least number to the greatest one, both rounded_up().
    void cover(double least, double greatest, double seconds);
    const PlotRange& present() const { return m_range; }

private:
    PlotRange m_range{};
    bool m_is_new = true;
    double m_needed = 0.0;  // s, when all of it was needed last
};
