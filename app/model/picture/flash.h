#pragma once

#include "model/look/extent.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

// Flashes as defined by success criterion 2.3.1 of WCAG 2.1. A general flash is a pair of opposing
// changes in relative luminance of 0.1 or more where the darker state is below 0.8. A red flash is
// a pair of opposing changes of (R - G - B) x 320 (below 0: 0) of more than 20. Before or after
// each change, R / (R + G + B) is 0.8 or more. The limit is three of either kind within a second,
// over more than a quarter of any field of 10 degrees.

/// The number of flashes within the last second.
struct Flashes {
    int general = 0;
    int red = 0;

    static constexpr int limit = 3;
    bool operator==(const Flashes&) const = default;
    int maximum() const { return general > red ? general : red; }
    bool is_beyond_limit() const { return maximum() > limit; }
};

/// Linear light, 0..1.
using Light = std::array<float, 3>;

/// Relative luminance, 0..1.
double luminance(const Light& light);

/// The grid of cells over a picture. Each cell is the mean light of its area, so that fine balanced
/// patterns, which WCAG excepts, become uniform grey.
inline constexpr Extent flash_cells{48, 36};
/// A field of 10 degrees, a third of the picture in each direction. This is WCAG's 341 x 256 of
/// 1024 x 768 pixels, if the picture fills the screen.
inline constexpr Extent flash_field{16, 12};

/// Counts the flashes of a picture frame by frame.
class FlashCounter {
public:
    FlashCounter();

    /// The flashes in the second that ends with this frame, reached by more than a quarter of the
    /// cells of some field. Each cell counts separately. `cells` are row by row; times ascend.
    Flashes add(double seconds, std::span<const Light> cells);

private:
    /// A value with its last extremes and direction of change.
    struct Swing {
        struct State {
            float number = 0.0f;
            bool is_red = false;  // saturated
        };
        State low;
        State high;
        std::int8_t direction = 0;  // of the last change: 1 up, -1 down, 0 no change yet
        bool is_new = true;

        template <class Counts>
        bool add(const State& now, Counts counts);
    };
    struct Changes {
        double seconds = 0.0;
        std::vector<std::uint16_t> cells;
    };
    /// For one kind of flash: the number of changes of each cell within the last second.
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
