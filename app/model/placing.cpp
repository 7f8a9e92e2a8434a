#include "model/placing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace {
constexpr int most_side = 16384;

// How the pixels of the picture become those of what is made.
struct Placing {
    Extent made;
    int repeat_x = 1;
    int repeat_y = 1;
};

int side_of(double length) {
    return std::clamp(static_cast<int>(std::lround(length)), 1, most_side);
}

// Only one side differs from the picture's own.
Placing fitted(Extent picture, double shape, bool is_whole) {
    const double wide = picture.height * shape;  // the width that has the viewport's shape
    const bool adds_width = wide > picture.width;
    if (adds_width == is_whole)
        return {{side_of(wide), picture.height}};
    return {{picture.width, side_of(picture.width / shape)}};
}

Placing placing_of(Extent picture, const SourceSpec& source, Extent viewport) {
    if (source.fit == Fit::stretch || viewport.is_empty())
        return {picture};
    if (source.fit == Fit::integer) {
        const double times = std::min(viewport.width / (picture.width * source.aspect),
                                      static_cast<double>(viewport.height) / picture.height);
        const int tall = std::max(1, static_cast<int>(times));
        return {viewport, std::max(1, static_cast<int>(std::lround(tall * source.aspect))), tall};
    }
    const double shape =
        static_cast<double>(viewport.width) / viewport.height / source.aspect;  // in pixels
    return fitted(picture, shape, source.fit == Fit::whole);
}
}  // namespace

Extent placed_extent(Extent picture, const SourceSpec& source, Extent viewport) {
    return placing_of(picture, source, viewport).made;
}

Picture placed(const Picture& picture, const SourceSpec& source, Extent viewport) {
    const Placing placing = placing_of(picture.extent, source, viewport);
    Picture made{placing.made, picture.channels, picture.encoding, {}};
    made.pixels.resize(made.index(0, made.extent.height));
    const auto channels = static_cast<std::size_t>(picture.channels);
    if (channels == 4)
        for (std::size_t i = 3; i < made.pixels.size(); i += 4)
            made.pixels[i] = 1.0f;
    const int shown_width = picture.extent.width * placing.repeat_x;
    const int shown_height = picture.extent.height * placing.repeat_y;
    const int left = static_cast<int>(std::floor((made.extent.width - shown_width) / 2.0));
    const int top = static_cast<int>(std::floor((made.extent.height - shown_height) / 2.0));
    const int first = std::max(left, 0);
    const int end = std::min(left + shown_width, made.extent.width);
    for (int y = std::max(top, 0); y < std::min(top + shown_height, made.extent.height); ++y) {
        const int from_y = (y - top) / placing.repeat_y;
        for (int x = first; x < end; ++x)
            std::copy_n(picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(
                                                     (x - left) / placing.repeat_x, from_y)),
                        channels,
                        made.pixels.begin() + static_cast<std::ptrdiff_t>(made.index(x, y)));
    }
    return made;
}

double placed_aspect(const SourceSpec& source) {
    return source.fit == Fit::integer ? 1.0 : source.aspect;
}

namespace {
constexpr std::array shape_names{
    std::pair{ViewShape::view, std::string_view("view")},
    std::pair{ViewShape::source, std::string_view("source")},
    std::pair{ViewShape::whole_pixels, std::string_view("whole pixels")}};
}

std::string_view shape_name(ViewShape shape) {
    return shape_names.at(static_cast<std::size_t>(shape)).second;
}

std::optional<ViewShape> find_shape(std::string_view name) {
    for (const auto& [shape, known] : shape_names)
        if (known == name)
            return shape;
    return std::nullopt;
}

Extent shaped(Extent view, ViewShape shape, Extent source, double pixel_aspect) {
    if (shape == ViewShape::view || source.is_empty() || view.is_empty())
        return view;
    const double width = source.width * pixel_aspect;
    double times = std::min(view.width / width, static_cast<double>(view.height) / source.height);
    if (shape == ViewShape::whole_pixels && times >= 1.0)
        times = std::floor(times);
    return {side_of(width * times), side_of(source.height * times)};
}
