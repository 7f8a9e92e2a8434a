#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Presets of a look, played one after another.
struct Playlist {
    enum class Unit { bars, seconds };

    std::vector<std::string> presets = {};  // names or files, as for --preset
    double every = 8.0;                     // bars or seconds per preset
    Unit unit = Unit::bars;
    double morph_seconds = 2.0;
    bool is_shuffled = false;

    bool operator==(const Playlist&) const = default;
};

constexpr double max_playlist_every = 10'000.0;
constexpr double max_playlist_morph = 600.0;  // s
constexpr std::size_t max_playlist_presets = 1000;

/// The index of the preset at a step of the list, of `count` > 0; steps can be negative. A shuffled
/// round has every preset once, and no preset follows itself. Fewer than three presets are not
/// shuffled.
std::size_t playlist_index(std::int64_t step, std::size_t count, bool is_shuffled,
                           std::uint64_t seed);
