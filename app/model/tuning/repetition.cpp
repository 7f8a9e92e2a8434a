#include "model/tuning/repetition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace {
Fraction reduced(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t common = std::gcd(numerator, denominator);
    return common > 1 ? Fraction{numerator / common, denominator / common}
                      : Fraction{numerator, denominator};
}

// nullopt: the number has more than six decimal places.
std::optional<Fraction> decimal_fraction(double number) {
    constexpr double rounding = 1e-13;  // relative, of a typed number
    constexpr std::int64_t largest_denominator = 1000000;
    for (std::int64_t denominator = 1; denominator <= largest_denominator; denominator *= 10) {
        const double numerator = number * static_cast<double>(denominator);
        if (std::abs(numerator - std::round(numerator)) <= rounding * numerator)
            return reduced(static_cast<std::int64_t>(std::round(numerator)), denominator);
    }
    return std::nullopt;
}
}  // namespace

Fraction fraction_of(double number) {
    if (const auto decimal = decimal_fraction(number))
        return *decimal;
    constexpr double tolerance = 1e-9;
    constexpr std::int64_t largest_denominator = 1000000;
    Fraction before{1, 0};
    Fraction now{static_cast<std::int64_t>(std::floor(number)), 1};
    double rest = number - std::floor(number);
    while (std::abs(now.number() - number) > tolerance * number && rest > 0.0) {
        const double inverse = 1.0 / rest;
        const double whole = std::floor(inverse);
        if (whole > static_cast<double>(largest_denominator))
            break;
        const auto term = static_cast<std::int64_t>(whole);
        const Fraction next{term * now.numerator + before.numerator,
                            term * now.denominator + before.denominator};
        if (next.denominator > largest_denominator)
            break;
        before = now;
        now = next;
        rest = inverse - whole;
    }
    return now;
}

Fraction reciprocal(const Fraction& fraction) {
    return {fraction.denominator, fraction.numerator};
}

namespace {
std::optional<std::int64_t> times(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    return __builtin_mul_overflow(a, b, &result) ? std::nullopt : std::optional(result);
}

// gcd(a / b, c / d) = gcd(a d, c b) / (b d).
std::optional<Fraction> common_divisor(const Fraction& a, const Fraction& b) {
    const auto first = times(a.numerator, b.denominator);
    const auto second = times(b.numerator, a.denominator);
    const auto denominator = times(a.denominator, b.denominator);
    if (!first || !second || !denominator)
        return std::nullopt;
    return reduced(std::gcd(*first, *second), *denominator);
}
}  // namespace

std::optional<Fraction> product(const Fraction& a, const Fraction& b) {
    const Fraction left = reduced(a.numerator, b.denominator);
    const Fraction right = reduced(b.numerator, a.denominator);
    const auto numerator = times(left.numerator, right.numerator);
    const auto denominator = times(left.denominator, right.denominator);
    return numerator && denominator ? std::optional(reduced(*numerator, *denominator))
                                    : std::nullopt;
}

void Repetition::add(double frequency) {
    constexpr double never = 1e-7;  // Hz, a period of months
    if (std::abs(frequency) > never)
        hertz.push_back(fraction_of(std::abs(frequency)));
}

void Repetition::add(const Repetition& other) {
    hertz.insert(hertz.end(), other.hertz.begin(), other.hertz.end());
    if (error.empty())
        error = other.error;
}

std::optional<Fraction> common_period(const Repetition& repetition) {
    constexpr double longest = 3600.0;
    if (repetition.hertz.empty())
        return Fraction{0, 1};
    std::optional<Fraction> common = repetition.hertz.front();
    for (const Fraction& frequency : repetition.hertz)
        if (common = common_divisor(*common, frequency); !common)
            return std::nullopt;
    const Fraction period = reciprocal(*common);
    return period.number() <= longest ? std::optional(period) : std::nullopt;
}

std::optional<std::int64_t> frames_of_period(const Fraction& seconds, double fps) {
    if (seconds.numerator == 0)
        return 1;
    const auto frames = product(seconds, fraction_of(fps));
    if (!frames)
        return std::nullopt;
    if (frames->is_whole())
        return frames->numerator;
    return frames->numerator == 1 ? std::optional<std::int64_t>(1) : std::nullopt;
}

std::vector<double> fitting_rates(const Fraction& seconds, double fps) {
    constexpr std::array usual{24.0, 25.0, 30.0, 48.0, 50.0, 60.0, 100.0, 120.0};
    std::vector<double> rates;
    for (const double rate : usual)
        if (frames_of_period(seconds, rate))
            rates.push_back(rate);
    if (!rates.empty() || seconds.numerator == 0)
        return rates;
    const double frames = std::floor(fps * seconds.number());
    for (const double count : {frames, frames + 1.0})
        if (count > 0.0)
            rates.push_back(count / seconds.number());
    return rates;
}
