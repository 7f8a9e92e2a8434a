#pragma once

#include "model/look/extent.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// A pixel under the pointer, from the top left.
struct Probe {
    std::string pass;  // or another texture, as in TextureChoice::label()
    int x = 0;
    int y = 0;
    bool is_of_variant = false;  // of the reference of a comparison
    Extent extent = {};          // size in px of the probed texture

    bool operator==(const Probe&) const = default;
};

/// A position that is probed in every pass: 0..1 from the left and from the top.
struct Pin {
    double x = 0.5;
    double y = 0.5;

    bool operator==(const Pin&) const = default;
    /// The texel at this position in a target.
    std::array<int, 2> texel(Extent extent) const;
};

/// The centre of a probed pixel.
Pin pin_at(const Probe& probe);

/// The line over the picture for the waveform.
struct ScanLine {
    Pin start{0.0, 0.5};
    Pin end{1.0, 0.5};

    bool operator==(const ScanLine&) const = default;
    /// A horizontal line through the centre of a row of texels.
    static ScanLine along_row(int row, int height);
    /// The row of a horizontal line; nullopt: not horizontal.
    std::optional<int> row(Extent extent) const;
};

/// The pixels and the line whose values are displayed.
struct Probes {
    std::optional<Probe> pointer;  // the pixel under it
    std::vector<Pin> pins;
    ScanLine scan_line;
    std::optional<double> scan_position;  // 0..1 along it, hovered in the plot
    bool plots_luminance = false;         // instead of red, green and blue
};
