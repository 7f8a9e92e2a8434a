#pragma once

#include "model/look/picture.h"
#include "model/picture/flash.h"
#include "model/picture/raw_picture.h"
#include "model/picture/subframe_cells.h"

#include <optional>
#include <span>
#include <string>

/// The cells of a picture: the mean of 64 samples each, as linear light 0..1.
std::vector<Light> cells_of(const Picture& picture);
/// The same cells as for picture_of(picture).
std::vector<Light> cells_of(const RawPicture& picture);

/// Checks a series of pictures for flashes above the limit.
class FlashLog {
public:
    /// Adds the next picture and its display time; times ascend.
    void add(const Picture& picture, double seconds) { add(cells_of(picture), seconds); }
    /// Sub-frames count as the mean of their source frame.
    void add(std::span<const Light> cells, double seconds, const Subframe& subframe = {});

    /// The maximum within any second.
    const Flashes& maximum() const { return m_maximum; }
    /// "the picture flashes up to 6 times a second (0 in red); the limit of WCAG 2.3.1 is 3. ...";
    /// nullopt if the limit is not exceeded.
    std::optional<std::string> warning() const;

private:
    SubframeCells m_subframes;
    FlashCounter m_counter;
    Flashes m_maximum;
    std::optional<double> m_first;  // s, of pictures above the limit
    double m_last = 0.0;
    int m_count = 0;  // pictures
};
