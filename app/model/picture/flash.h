#pragma once

#include "model/look/extent.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

// What flashes, by success criterion 2.3.1 of WCAG 2.1. A general flash is a pair of opposing
// changes in relative luminance of 0.1 or more where the darker state is below 0.8. A red flash is
// a pair of opposing changes of (R - G - B) x 320 (below 0: 0) of more than 20, where R / (R + G +
// B) is 0.8 or more before or after each. More than three of either within a second, over more than
// a quarter of any field of 10 degrees, is beyond the limit.

/// How often something flashed within the last second.
struct Flashes {
    int general = 0;
    int red = 0;

    static constexpr int limit = 3;
    bool operator==(const Flashes&) const = default;
    int most() const { return general > red ? general : red; }
    bool is_beyond_limit() const { return most() > limit; }
};

/// Linear light, 0..1.
using Light = std::array<float, 3>;

/// Relative luminance, 0..1.
double luminance(const Light& light);

/// How a picture is cut for this: each cell is the mean light of its part, so that fine balanced
/// patterns, which WCAG excepts, come to an even grey.
inline constexpr Extent flash_cells{48, 36};
/// A field of 10 degrees: WCAG's 341 x 256 pixels of a screen of 1024 x 768, which the picture is
/// taken to fill; a third of it in each direction.
inline constexpr Extent flash_field{16, 12};

/// Counts the flashes of a picture frame by frame.
class FlashCounter {
public:
    FlashCounter();

    /// Of the second that ends with this frame: what more than a quarter of the cells of some field
    /// have reached, each counted on its own. Cells row by row; times go up.
    Flashes add(double seconds, std::span<const Light> cells);

private:
    /// A number that swings, and how it last turned.
    struct Swing {
        struct State {
            float number = 0.0f;
            bool is_red = false;  // saturated
        };
        State low;
        State high;
        std::int8_t direction = 0;  // of the last change: 1 up, -1 down, 0 none so far
        bool is_new = true;

        template <class Counts>
        bool add(const State& now, Counts counts);
    };
    struct Changes {
        double seconds = 0.0;
        std::vector<std::uint16_t> cells;
    };
    /// Of one kind: how many changes each cell had within the last second.
    struct Tally {
        std::vector<Swing> swings;
        std::vector<int> changes;
        std::deque<Changes> latest;

        void note(double seconds, std::vector<std::uint16_t> cells);
        int flashes() const;
    };

    Tally m_general;
    Tally m_red;
};
