#include "model/picture/placing.h"

#include "model/picture/byte_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace {
constexpr int max_side = 16384;

// The mapping from the pixels of a picture to those of the result.
struct Placing {
    Extent made;
    int repeat_x = 1;
    int repeat_y = 1;
    int shrink = 1;  // this number of pixels per side is averaged first
};

int side_of(double length) {
    return std::clamp(static_cast<int>(std::lround(length)), 1, max_side);
}

// Changes only one side of the picture.
Placing fitted(Extent picture, double shape, bool is_whole) {
    const double wide = picture.height * shape;  // the width for the viewport's shape
    const bool adds_width = wide > picture.width;
    if (adds_width == is_whole)
        return {{side_of(wide), picture.height}};
    return {{picture.width, side_of(picture.width / shape)}};
}

Extent shrunk(Extent extent, int times) {
    return {std::max(extent.width / times, 1), std::max(extent.height / times, 1)};
}

// Limits memory: a strip of 16384 x 1 pixels in a square would need a gigabyte of black.
Placing fitted_in_memory(Extent picture, double shape, bool is_whole) {
    constexpr double max_pixels = 1 << 25;
    Placing placing = fitted(picture, shape, is_whole);
    const double pixels = static_cast<double>(placing.made.width) * placing.made.height;
    const int shrink = static_cast<int>(std::ceil(std::sqrt(pixels / max_pixels)));
    if (shrink <= 1)
        return placing;
    placing = fitted(shrunk(picture, shrink), shape, is_whole);
    placing.shrink = shrink;
    return placing;
}

Placing placing_of(Extent picture, const SourceSpec& source, Extent viewport) {
    if (source.fit == Fit::stretch || viewport.is_empty())
        return {picture};
    const double aspect = pixel_aspect(source, picture);
    if (source.fit == Fit::integer) {
        const double times = std::min(viewport.width / (picture.width * aspect),
                                      static_cast<double>(viewport.height) / picture.height);
        const int tall = std::max(1, static_cast<int>(times));
        return {viewport, std::max(1, static_cast<int>(std::lround(tall * aspect))), tall};
    }
    const double shape =
        static_cast<double>(viewport.width) / viewport.height / aspect;  // in pixels of the picture
    return fitted_in_memory(picture, shape, source.fit == Fit::whole);
}

// The part of the result that shows the picture, px.
Extent shown_extent(Extent picture, const Placing& placing) {
    const Extent smaller = placing.shrink > 1 ? shrunk(picture, placing.shrink) : picture;
    return {smaller.width * placing.repeat_x, smaller.height * placing.repeat_y};
}

// From the left and the top; negative if the picture is cropped.
std::pair<int, int> first_pixel(Extent made, Extent shown) {
    return {static_cast<int>(std::floor((made.width - shown.width) / 2.0)),
            static_cast<int>(std::floor((made.height - shown.height) / 2.0))};
}

// Each pixel is the mean of `times` x `times` stored values; fewer at the right and bottom edges.
Picture averaged(const Picture& picture, int times) {
    Picture made{shrunk(picture.extent, times), picture.channels, picture.encoding, {}};
    const auto channels = static_cast<std::size_t>(picture.channels);
    made.pixels.assign(made.index(0, made.extent.height), 0.0f);
    for (int y = 0; y < made.extent.height; ++y)
        for (int x = 0; x < made.extent.width; ++x) {
            const int end_x = std::min((x + 1) * times, picture.extent.width);
            const int end_y = std::min((y + 1) * times, picture.extent.height);
            const auto count = static_cast<float>((end_x - x * times) * (end_y - y * times));
            float* const mean = made.pixels.data() + made.index(x, y);
            for (int from_y = y * times; from_y < end_y; ++from_y)
                for (int from_x = x * times; from_x < end_x; ++from_x)
                    for (std::size_t i = 0; i < channels; ++i)
                        mean[i] += picture.pixels[picture.index(from_x, from_y) + i] / count;
        }
    return made;
}
}  // namespace

Extent placed_extent(Extent picture, const SourceSpec& source, Extent viewport) {
    return placing_of(picture, source, viewport).made;
}

namespace {
// Copies the visible pixels into a result that has `channels` values per pixel.
template <typename Number>
void place_pixels(const Picture& picture, const Number* from, const Placing& placing, Picture& made,
                  Number* to) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const Extent shown{picture.extent.width * placing.repeat_x,
                       picture.extent.height * placing.repeat_y};
    const auto [left, top] = first_pixel(made.extent, shown);
    const int first = std::max(left, 0);
    const int end = std::min(left + shown.width, made.extent.width);
    for (int y = std::max(top, 0); y < std::min(top + shown.height, made.extent.height); ++y) {
        const int from_y = (y - top) / placing.repeat_y;
        if (placing.repeat_x == 1) {
            std::copy_n(from + picture.index(first - left, from_y),
                        static_cast<std::size_t>(std::max(end - first, 0)) * channels,
                        to + made.index(first, y));
            continue;
        }
        for (int x = first; x < end; ++x)
            std::copy_n(from + picture.index((x - left) / placing.repeat_x, from_y), channels,
                        to + made.index(x, y));
    }
}
}  // namespace

Picture placed(const Picture& given, const SourceSpec& source, Extent viewport) {
    const Placing placing = placing_of(given.extent, source, viewport);
    Picture smaller;
    if (placing.shrink > 1)
        smaller = averaged(with_floats(given), placing.shrink);
    const Picture& picture = placing.shrink > 1 ? smaller : given;
    Picture made{placing.made, picture.channels, picture.encoding, {}};
    const std::size_t size = made.index(0, made.extent.height);
    if (picture.bytes) {
        const auto bytes = std::make_shared<std::vector<std::uint8_t>>(size);
        place_pixels(picture, picture.bytes.get(), placing, made, bytes->data());
        made.bytes = {bytes, bytes->data()};
        return made;
    }
    made.pixels.resize(size);
    if (picture.channels == 4)
        for (std::size_t i = 3; i < made.pixels.size(); i += 4)
            made.pixels[i] = 1.0f;
    place_pixels(picture, picture.pixels.data(), placing, made, made.pixels.data());
    return made;
}

double placed_aspect(const SourceSpec& source, Extent picture) {
    return source.fit == Fit::integer ? 1.0 : pixel_aspect(source, picture);
}

namespace {
// `shown`: pixels of the result that the source's lines cover, starting at `first`.
RasterAxis lines_of(int count, int shown, int first, int made) {
    return {static_cast<double>(first) / made, static_cast<double>(shown) / count / made, count};
}
}  // namespace

SourceRaster placed_raster(Extent picture, const SourceSpec& source, Extent viewport) {
    const Placing placing = placing_of(picture, source, viewport);
    const Extent shown = shown_extent(picture, placing);
    const auto [left, top] = first_pixel(placing.made, shown);
    return {.rows = lines_of(picture.height, shown.height, top, placing.made.height),
            .columns = lines_of(picture.width, shown.width, left, placing.made.width)};
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
