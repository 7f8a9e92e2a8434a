#include "model/picture/solid_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace {
constexpr int cube_faces = 6;

/// The position of a face in a cross, in squares from the top left.
struct FacePosition {
    int column;
    int row;
    bool is_turned = false;  // rotated by 180 degrees
};

constexpr std::array<FacePosition, cube_faces> wide_cross{
    {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
constexpr std::array<FacePosition, cube_faces> high_cross{
    {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}};

Picture empty_solid(const Picture& flat, int side, int layers, PictureShape shape) {
    Picture solid{{side, side * layers}, flat.channels, flat.encoding, {}, shape};
    solid.pixels.reserve(solid.index(0, side * layers));
    return solid;
}

void append_texel(const Picture& flat, int x, int y, Picture& solid) {
    const auto texel = flat.pixels.begin() + static_cast<std::ptrdiff_t>(flat.index(x, y));
    solid.pixels.insert(solid.pixels.end(), texel, texel + flat.channels);
}

Picture from_cross(const Picture& flat, int side,
                   const std::array<FacePosition, cube_faces>& faces) {
    Picture solid = empty_solid(flat, side, cube_faces, PictureShape::cube);
    for (const FacePosition& face : faces)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                append_texel(flat, face.column * side + (face.is_turned ? side - 1 - x : x),
                             face.row * side + (face.is_turned ? side - 1 - y : y), solid);
    return solid;
}

Picture from_row(const Picture& flat, int side, int layers, PictureShape shape) {
    Picture solid = empty_solid(flat, side, layers, shape);
    for (int layer = 0; layer < layers; ++layer)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                append_texel(flat, layer * side + x, y, solid);
    return solid;
}

// Bilinear, at a position in texels; wraps around horizontally.
void append_sample(const Picture& flat, double x, double y, Picture& solid) {
    const int width = flat.extent.width;
    const auto left = static_cast<int>(std::floor(x - 0.5));
    const auto top = static_cast<int>(std::floor(y - 0.5));
    const double right_share = x - 0.5 - left;
    const double low_share = y - 0.5 - top;
    const auto at = [&](int column, int row, int channel) {
        const int wrapped = (column % width + width) % width;
        const int held = std::clamp(row, 0, flat.extent.height - 1);
        return static_cast<double>(
            flat.pixels[flat.index(wrapped, held) + static_cast<std::size_t>(channel)]);
    };
    for (int channel = 0; channel < flat.channels; ++channel) {
        const double high =
            std::lerp(at(left, top, channel), at(left + 1, top, channel), right_share);
        const double low =
            std::lerp(at(left, top + 1, channel), at(left + 1, top + 1, channel), right_share);
        solid.pixels.push_back(static_cast<float>(std::lerp(high, low, low_share)));
    }
}

Picture from_panorama(const Picture& flat) {
    const int side = flat.extent.height / 2;
    Picture solid = empty_solid(flat, side, cube_faces, PictureShape::cube);
    for (int face = 0; face < cube_faces; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Direction direction =
                    cube_direction(face, (x + 0.5) / side, (y + 0.5) / side);
                const double longitude = std::atan2(direction.x, direction.z);
                const double latitude =
                    std::atan2(direction.y, std::hypot(direction.x, direction.z));
                append_sample(flat,
                              (0.5 + longitude / (2.0 * std::numbers::pi)) * flat.extent.width,
                              (0.5 - latitude / std::numbers::pi) * flat.extent.height, solid);
            }
    return solid;
}

Result<Picture> cube_of(const Picture& flat) {
    const auto [width, height] = flat.extent;
    if (width == 1 && height == 1)
        return from_cross(flat, 1, {});
    if (width == cube_faces * height)
        return from_row(flat, height, cube_faces, PictureShape::cube);
    if (3 * width == 4 * height && width % 4 == 0)
        return from_cross(flat, width / 4, wide_cross);
    if (4 * width == 3 * height && width % 3 == 0)
        return from_cross(flat, width / 3, high_cross);
    if (width == 2 * height && height >= 2)
        return from_panorama(flat);
    return fail({{},
                 0,
                 fmt::format("can't be a cube map at {} x {} px. Use six squares in a row or "
                             "column, a cross of 4 x 3 or 3 x 4 squares, or a 2:1 panorama.",
                             width, height)});
}
}  // namespace

// OpenGL 4.1, table 3.19.
Direction cube_direction(int face, double s, double t) {
    const double u = 2.0 * s - 1.0;
    const double v = 2.0 * t - 1.0;
    const std::array<Direction, cube_faces> faces{
        {{1.0, -v, -u}, {-1.0, -v, u}, {u, 1.0, v}, {u, -1.0, -v}, {u, -v, 1.0}, {-u, -v, -1.0}}};
    return faces[static_cast<std::size_t>(face)];
}

Result<Picture> solid_of(const Picture& flat, PictureShape wanted) {
    if (flat.shape == wanted)
        return flat;
    const auto [width, height] = flat.extent;
    const int layers = wanted == PictureShape::cube ? cube_faces : width;
    if (flat.shape == PictureShape::flat && wanted != PictureShape::flat &&
        static_cast<std::int64_t>(layers) * width == height) {
        Picture solid = flat;
        solid.shape = wanted;
        return solid;
    }
    if (flat.shape == PictureShape::flat && wanted == PictureShape::cube)
        return cube_of(flat);
    if (flat.shape == PictureShape::flat && wanted == PictureShape::volume &&
        static_cast<std::int64_t>(height) * height == width)
        return from_row(flat, height, height, PictureShape::volume);
    if (flat.shape == PictureShape::flat && wanted == PictureShape::volume)
        return fail({{},
                     0,
                     fmt::format("can't be a volume at {} x {} px. Use a row or column of N square "
                                 "slices, each N px wide.",
                                 width, height)});
    return fail({{}, 0, "is not a flat picture"});
}
