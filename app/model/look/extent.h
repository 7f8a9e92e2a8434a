#pragma once

/// A size in pixels.
struct Extent {
    int width = 0;
    int height = 0;

    bool operator==(const Extent&) const = default;
    bool is_empty() const { return width <= 0 || height <= 0; }
};
