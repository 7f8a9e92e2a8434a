#include "model/photo/photo.h"

#include "model/photo/pixel_index.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
// Weights of four pixels at a fraction 0..1 between the middle two (Catmull and Rom 1974, tension
// 1/2).
std::array<float, 4> cubic_weights(float t) {
    const float s = t * t;
    const float c = s * t;
    return {-0.5F * t + s - 0.5F * c, 1.0F - 2.5F * s + 1.5F * c, 0.5F * t + 2.0F * s - 1.5F * c,
            -0.5F * s + 0.5F * c};
}
}  // namespace

Photo::Photo(const Picture& picture) : m_extent(picture.extent) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const std::size_t count = picture.pixels.size() / channels;
    m_pixels.resize(count);
    Level level{m_extent, std::vector<glm::vec3>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const float* from = &picture.pixels[i * channels];
        const glm::vec3 value = glm::max(glm::vec3(from[0], from[1], from[2]), 0.0F);
        m_pixels[i] = value * value;
        level.light[i] = glm::pow(value, glm::vec3(static_cast<float>(mean_gamma)));
    }
    m_levels.push_back(std::move(level));
    while (m_levels.back().extent.width > 8 && m_levels.back().extent.height > 8) {
        const Level& fine = m_levels.back();
        const Extent extent{fine.extent.width / 2, fine.extent.height / 2};
        Level half{extent, {}};
        half.light.reserve(static_cast<std::size_t>(extent.width) *
                           static_cast<std::size_t>(extent.height));
        for (int y = 0; y < extent.height; ++y)
            for (int x = 0; x < extent.width; ++x)
                half.light.push_back(0.25F *
                                     (fine.light[pixel_index(fine.extent, 2 * x, 2 * y)] +
                                      fine.light[pixel_index(fine.extent, 2 * x + 1, 2 * y)] +
                                      fine.light[pixel_index(fine.extent, 2 * x, 2 * y + 1)] +
                                      fine.light[pixel_index(fine.extent, 2 * x + 1, 2 * y + 1)]));
        m_levels.push_back(std::move(half));
    }
}

const glm::vec3& Photo::pixel(int x, int y) const {
    return m_pixels[pixel_index(m_extent, x, y)];
}

glm::vec3 Photo::at(glm::dvec2 position) const {
    const glm::dvec2 from_centre = position - 0.5;
    const glm::dvec2 base = glm::floor(from_centre);
    const glm::vec2 share(from_centre - base);
    const std::array<float, 4> across = cubic_weights(share.x);
    const std::array<float, 4> down = cubic_weights(share.y);
    glm::vec3 value(0.0F);
    for (int j = 0; j < 4; ++j) {
        glm::vec3 row(0.0F);
        for (int i = 0; i < 4; ++i)
            row += across[static_cast<std::size_t>(i)] *
                   pixel(static_cast<int>(base.x) + i - 1, static_cast<int>(base.y) + j - 1);
        value += down[static_cast<std::size_t>(j)] * row;
    }
    return value;
}

glm::vec3 Photo::between_texels(const Level& level, glm::dvec2 texel) {
    const glm::dvec2 base = glm::floor(texel);
    const glm::vec2 share(texel - base);
    const auto at = [&](int dx, int dy) {
        return level.light[pixel_index(level.extent, static_cast<int>(base.x) + dx,
                                       static_cast<int>(base.y) + dy)];
    };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), share.x), glm::mix(at(0, 1), at(1, 1), share.x),
                    share.y);
}

glm::vec3 Photo::mean_light_at(glm::dvec2 position, const glm::dmat2& sides, int count) const {
    const double distance = std::max(glm::length(sides[0]), glm::length(sides[1])) / count;
    const auto number =
        std::min(static_cast<std::size_t>(std::log2(std::max(distance, 1.0))), m_levels.size() - 1);
    const double texel = std::exp2(static_cast<double>(number));  // px
    glm::vec3 light(0.0F);
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 offset = (glm::dvec2(i, j) + 0.5) / static_cast<double>(count) - 0.5;
            light += between_texels(m_levels[number], (position + sides * offset) / texel - 0.5);
        }
    return light / static_cast<float>(count * count);
}
