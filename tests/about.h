#pragma once

#include <doctest/doctest.h>

/// Equals what lies within a share of `expected` itself. doctest's own tolerance is a share of
/// 1 + |expected|: for a small number that is most of it.
inline doctest::Approx about(double expected, double share) {
    return doctest::Approx(expected).epsilon(share).scale(0.0);
}
