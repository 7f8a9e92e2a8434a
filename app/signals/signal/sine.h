#pragma once

#include <cstdint>

/// The nearest whole number, for |x| below 2^51. Adding 1.5 * 2^52 leaves no bits for the fraction
/// of a double.
inline double nearest(double x) {
    constexpr double shift = 6755399441055744.0;
    return (x + shift) - shift;
}

/// x - floor(x): 0 <= result < 1, for |x| below 2^62.
inline double fraction(double x) {
    const double rest = x - static_cast<double>(static_cast<std::int64_t>(x));
    return rest < 0.0 ? rest + 1.0 : rest;
}

/// sin(2 pi x), x in turns: Taylor series over a quarter turn, error below 1e-11. Bit-identical on
/// every machine and several times faster than std::sin.
inline double sine(double turns) {
    constexpr double two_pi = 6.283185307179586;
    double rest = turns - nearest(turns);
    if (rest > 0.25)
        rest = 0.5 - rest;
    else if (rest < -0.25)
        rest = -0.5 - rest;
    const double a = two_pi * rest;
    const double b = a * a;
    double sum = -1.0 / 1307674368000.0;  // 15!
    sum = sum * b + 1.0 / 6227020800.0;   // 13!
    sum = sum * b - 1.0 / 39916800.0;
    sum = sum * b + 1.0 / 362880.0;
    sum = sum * b - 1.0 / 5040.0;
    sum = sum * b + 1.0 / 120.0;
    sum = sum * b - 1.0 / 6.0;
    return a + a * b * sum;
}

inline double cosine(double turns) {
    return sine(turns + 0.25);
}
