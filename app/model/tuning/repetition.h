#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// A fraction in lowest terms; the denominator is positive.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;

    double number() const {
        return static_cast<double>(numerator) / static_cast<double>(denominator);
    }
    bool is_whole() const { return denominator == 1; }
    bool operator==(const Fraction&) const = default;
};

/// The fraction of a number with up to six decimal places. Of other numbers, the fraction with the
/// smallest denominator whose relative error is at most 1e-9, by continued fractions; a denominator
/// is at most 1e6. For numbers of at least 0.
Fraction fraction_of(double number);
Fraction reciprocal(const Fraction& fraction);
/// nullopt: too large to represent.
std::optional<Fraction> product(const Fraction& a, const Fraction& b);

/// How something repeats over time: the frequencies of its periodic parts.
struct Repetition {
    std::vector<Fraction> hertz = {};  // each above 0; none: it does not change
    std::string error = {};            // why it never repeats, as a sentence; "": it repeats

    /// Adds a part with a frequency in Hz; 0 adds nothing.
    void add(double frequency);
    void add(const Repetition& other);
};

/// The time after which all parts have completed whole periods, in seconds: the reciprocal of the
/// greatest common divisor of the frequencies. 0: nothing changes. nullopt: longer than an hour.
std::optional<Fraction> common_period(const Repetition& repetition);

/// The whole number of frames that shows one period. A period that is shorter than a frame and
/// divides it stands still: 1 frame. nullopt: no whole number of frames shows it.
std::optional<std::int64_t> frames_of_period(const Fraction& seconds, double fps);

/// Frame rates at which one period is a whole number of frames, ascending: usual ones, otherwise
/// the nearest to `fps`.
std::vector<double> fitting_rates(const Fraction& seconds, double fps);
