#include "signals/patterns/solids.h"

#include "model/picture/solid_picture.h"
#include "signals/patterns/hash.h"
#include "signals/patterns/tiled_noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
using LinearColor = std::array<double, 3>;

LinearColor mixed(const LinearColor& a, const LinearColor& b, double share) {
    return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share),
            std::lerp(a[2], b[2], share)};
}

LinearColor color_of_sky(const Direction& direction) {
    constexpr LinearColor zenith{0.20, 0.42, 0.75};
    constexpr LinearColor haze{0.80, 0.86, 0.92};
    constexpr LinearColor near_ground{0.30, 0.27, 0.23};
    constexpr LinearColor far_ground{0.55, 0.52, 0.47};
    constexpr LinearColor cloud{0.98, 0.98, 1.0};
    constexpr LinearColor sunlight{1.0, 0.97, 0.85};
    constexpr std::array sun{0.48, 0.60, 0.64};
    const double length = std::hypot(direction.x, direction.y, direction.z);
    const double height = direction.y / length;
    if (height < 0.0)
        return mixed(far_ground, near_ground, std::sqrt(-height));
    const double near =
        (direction.x * sun[0] + direction.y * sun[1] + direction.z * sun[2]) / length;
    const double noise = tiled_fractal_noise(
        {direction.x / length * 0.5, height * 0.9, direction.z / length * 0.5}, 4, 7);
    LinearColor color = mixed(haze, zenith, std::pow(height, 0.6));
    color = mixed(color, cloud, std::clamp((noise - 0.48) * 5.0, 0.0, 0.9) * std::sqrt(height));
    constexpr double disc = 0.995;  // cosine of its angular radius
    return mixed(color, sunlight, near > disc ? 1.0 : 0.6 * std::pow(std::max(near, 0.0), 24.0));
}

Picture make_sky() {
    constexpr int side = 128;
    constexpr int faces = 6;
    Picture picture{{side, side * faces}, 3, Encoding::display, {}, PictureShape::cube};
    for (int face = 0; face < faces; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                for (const double part :
                     color_of_sky(cube_direction(face, (x + 0.5) / side, (y + 0.5) / side)))
                    picture.pixels.push_back(static_cast<float>(part));
    return picture;
}

Picture make_volume(bool is_grey) {
    constexpr int side = 32;
    constexpr std::uint32_t texels = side * side * side;
    Picture picture{{side, side * side}, 4, Encoding::display, {}, PictureShape::volume};
    for (std::uint32_t texel = 0; texel < texels; ++texel)
        for (std::uint32_t channel = 0; channel < 4; ++channel)
            picture.pixels.push_back(static_cast<float>(
                std::floor(hash_to_unit(texel, is_grey ? 0 : channel, 3) * 256.0) / 255.0));
    return picture;
}
}  // namespace

Result<Picture> make_solid(std::string_view name) {
    if (name == "sky")
        return make_sky();
    if (name == "grey-volume" || name == "noise-volume")
        return make_volume(name == "grey-volume");
    return fail(
        {{},
         0,
         fmt::format("unknown cube or volume '{}'; use sky, grey-volume or noise-volume", name)});
}
