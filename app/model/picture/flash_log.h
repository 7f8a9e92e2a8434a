#pragma once

#include "model/look/picture.h"
#include "model/picture/flash.h"
#include "model/picture/raw_picture.h"

#include <optional>
#include <span>
#include <string>

/// The cells of a picture: of each the mean of 64 places, as linear light 0..1.
std::vector<Light> cells_of(const Picture& picture);
/// The same cells as of picture_of(picture).
std::vector<Light> cells_of(const RawPicture& picture);

/// Watches a run of pictures for flashes beyond the limit.
class FlashLog {
public:
    /// The next picture, and when it is seen; times go up.
    void add(const Picture& picture, double seconds) { add(cells_of(picture), seconds); }
    void add(std::span<const Light> cells, double seconds);

    /// The most within any second.
    const Flashes& most() const { return m_most; }
    /// "up to 6 general and 0 red flashes within a second, first beyond the limit at 0.70 s, ...";
    /// none while all is within it.
    std::optional<std::string> warning() const;

private:
    FlashCounter m_counter;
    Flashes m_most;
    std::optional<double> m_first;  // s, of what is beyond
    double m_last = 0.0;
    int m_count = 0;  // pictures
};
