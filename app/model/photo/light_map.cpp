#include "model/photo/light_map.h"

#include "model/look/color.h"
#include "model/photo/pixel_index.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
// The weights of the pixels at the distances 0, 1, 2, ... px.
std::vector<float> gaussian(double sigma) {
    const int reach = static_cast<int>(std::ceil(4.0 * sigma));
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = 0; i <= reach; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        sum += (i == 0 ? 1.0 : 2.0) * weights.back();
    }
    std::vector<float> normalised;
    for (const double weight : weights)
        normalised.push_back(static_cast<float>(weight / sum));
    return normalised;
}

LightMap blurred_along(const LightMap& map, const std::vector<float>& weights, glm::ivec2 step) {
    LightMap result{map.extent, std::vector<float>(map.light.size())};
    for (int y = 0; y < map.extent.height; ++y)
        for (int x = 0; x < map.extent.width; ++x) {
            float sum = weights[0] * map.light[pixel_index(map.extent, x, y)];
            for (int i = 1; i < static_cast<int>(weights.size()); ++i)
                sum += weights[static_cast<std::size_t>(i)] *
                       (map.light[pixel_index(map.extent, x + i * step.x, y + i * step.y)] +
                        map.light[pixel_index(map.extent, x - i * step.x, y - i * step.y)]);
            result.light[pixel_index(map.extent, x, y)] = sum;
        }
    return result;
}

// The channel with the most light. Bright places count most, so dim light of the room does not.
std::size_t strongest_channel(const Picture& picture) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::array<double, 3> sums{};
    for (std::size_t i = 0; i + 2 < picture.pixels.size(); i += channels)
        for (std::size_t channel = 0; channel < 3; ++channel)
            sums.at(channel) += std::pow(static_cast<double>(picture.pixels[i + channel]), 4);
    return static_cast<std::size_t>(std::ranges::max_element(sums) - sums.begin());
}

template <typename Decode>
LightMap strongest_light(const Picture& picture, Decode decode) {
    LightMap map{picture.extent, {}};
    const auto channels = static_cast<std::size_t>(picture.channels);
    map.light.reserve(picture.pixels.size() / channels);
    for (std::size_t i = strongest_channel(picture); i < picture.pixels.size(); i += channels)
        map.light.push_back(decode(std::max(picture.pixels[i], 0.0F)));
    return map;
}
}  // namespace

float LightMap::at(glm::dvec2 position) const {
    const glm::dvec2 from_centre = position - 0.5;
    const glm::dvec2 base = glm::floor(from_centre);
    const glm::vec2 share(from_centre - base);
    const int x = static_cast<int>(base.x);
    const int y = static_cast<int>(base.y);
    const auto pixel = [&](int dx, int dy) { return light[pixel_index(extent, x + dx, y + dy)]; };
    return glm::mix(glm::mix(pixel(0, 0), pixel(1, 0), share.x),
                    glm::mix(pixel(0, 1), pixel(1, 1), share.x), share.y);
}

LightMap light_map(const Picture& picture) {
    if (picture.encoding == Encoding::linear)
        return strongest_light(picture, [](float value) { return value; });
    return strongest_light(picture, [](float value) {
        return static_cast<float>(srgb_decode(static_cast<double>(value)));
    });
}

LightMap light_of_photo(const Picture& photo, double gamma) {
    return strongest_light(
        photo, [power = static_cast<float>(gamma)](float value) { return std::pow(value, power); });
}

LightMap blurred(const LightMap& map, double sigma) {
    if (sigma <= 0.0)
        return map;
    const std::vector<float> weights = gaussian(sigma);
    return blurred_along(blurred_along(map, weights, {1, 0}), weights, {0, 1});
}
