#pragma once

#include <doctest/doctest.h>

#include <cmath>

/// Equals what lies within a share of `expected` itself. doctest's own tolerance is a share of
/// 1 + |expected|: for a small number that is most of it.
inline doctest::Approx about(double expected, double share) {
    return doctest::Approx(expected).epsilon(share).scale(0.0);
}

/// Lies within `tolerance` of `expected`.
inline bool is_near(double value, double expected, double tolerance = 1e-12) {
    return std::abs(value - expected) <= tolerance;
}
