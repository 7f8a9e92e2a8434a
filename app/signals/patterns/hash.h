#pragma once

#include <cstdint>

/// A pseudo-random number that depends only on the keys, on every machine. Applies the finaliser of
/// MurmurHash3 (A. Appleby) to each key in turn.
inline std::uint32_t hash_of(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
    const auto mix = [](std::uint32_t key) {
        key ^= key >> 16u;
        key *= 0x85ebca6bu;
        key ^= key >> 13u;
        key *= 0xc2b2ae35u;
        return key ^ (key >> 16u);
    };
    return mix(c + mix(b + mix(a + 0x9e3779b9u)));
}

/// hash_of() scaled to 0 <= n < 1.
inline double hash_to_unit(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
    return hash_of(a, b, c) / 4294967296.0;
}
