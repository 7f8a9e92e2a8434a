#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Uniform random numbers in 0..1; SplitMix64 (Steele, Lea and Flood 2014), the same on all
/// machines.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : m_state(seed) {}

    double next() {
        m_state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return std::ldexp(static_cast<double>((z ^ (z >> 31)) >> 11), -53);
    }
    /// One of 0 .. count - 1.
    double choose(double count) { return std::min(std::floor(next() * count), count - 1.0); }

private:
    std::uint64_t m_state;
};
