#pragma once

/// An area of the window, in window coordinates from the top left corner.
struct Rect {
    float left = 0.0f;
    float top = 0.0f;
    float width = 0.0f;
    float height = 0.0f;

    float right() const { return left + width; }
    float bottom() const { return top + height; }
    bool is_shown() const { return width > 0.0f && height > 0.0f; }
};
