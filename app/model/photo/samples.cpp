#include "model/photo/samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr int slope_margin = 3;   // px, of values for their slopes
constexpr int chroma_margin = 4;  // px, after the mosaic
constexpr int mosaic_margin = 3;  // px, after the blur of light
constexpr int value_side = SampleLayout::side + 2 * slope_margin;
constexpr int mosaic_side = value_side + 2 * chroma_margin;
constexpr int blurred_side = mosaic_side + 2 * mosaic_margin;
constexpr int max_reach = SampleLayout::margin - slope_margin - chroma_margin - mosaic_margin;

constexpr std::size_t index_of(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
}

constexpr std::size_t square(int side) {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
}

double across_scale(const glm::dmat2& map) {
    return glm::length(map[0]);
}

double down_scale(const glm::dmat2& map) {
    return glm::length(map[1]);
}

// A normalised Gaussian of 2 * reach + 1 numbers.
struct Kernel {
    int reach = 0;
    std::array<float, static_cast<std::size_t>(2 * max_reach + 1)> weights{};

    // 0 beyond the reach.
    float& at(int i) { return weights[index_of(i + max_reach, 0, 0)]; }
    float at(int i) const { return weights[index_of(i + max_reach, 0, 0)]; }
};

Kernel gaussian(double sigma, int most) {
    Kernel kernel;
    kernel.reach = std::min(static_cast<int>(std::ceil(4.0 * sigma)), most);
    double sum = 0.0;
    const auto weight = [&](int i) {
        return sigma > 0.0 ? std::exp(-0.5 * i * i / (sigma * sigma)) : 1.0;
    };
    for (int i = -kernel.reach; i <= kernel.reach; ++i)
        sum += weight(i);
    for (int i = -kernel.reach; i <= kernel.reach; ++i)
        kernel.at(i) = static_cast<float>(weight(i) / sum);
    return kernel;
}

// Blur and sharpening at a scale: photo px per px.
Kernel lens_kernel(const Camera& camera, double scale) {
    constexpr double removed = 1.0;  // px of the photo
    const Kernel narrow = gaussian(camera.blur / scale, max_reach);
    const Kernel wide = gaussian(std::hypot(camera.blur, removed) / scale, max_reach);
    const auto share = static_cast<float>(camera.sharpening);
    Kernel kernel;
    kernel.reach = std::max(narrow.reach, wide.reach);
    for (int i = -kernel.reach; i <= kernel.reach; ++i)
        kernel.at(i) = (1.0F + share) * narrow.at(i) - share * wide.at(i);
    return kernel;
}

// A square with a margin becomes a smaller square by two one-dimensional convolutions.
void convolve(const glm::vec3* from, int from_side, const Kernel& across, const Kernel& down,
              glm::vec3* to, int to_side) {
    const int margin = (from_side - to_side) / 2;
    std::vector<glm::vec3> rows(static_cast<std::size_t>(from_side) *
                                static_cast<std::size_t>(to_side));
    for (int y = 0; y < from_side; ++y)
        for (int x = 0; x < to_side; ++x) {
            glm::vec3 sum(0.0F);
            for (int i = -across.reach; i <= across.reach; ++i)
                sum += across.at(i) * from[y * from_side + x + margin + i];
            rows[index_of(x, y, to_side)] = sum;
        }
    for (int y = 0; y < to_side; ++y)
        for (int x = 0; x < to_side; ++x) {
            glm::vec3 sum(0.0F);
            for (int i = -down.reach; i <= down.reach; ++i)
                sum += down.at(i) * rows[index_of(x, y + margin + i, to_side)];
            to[y * to_side + x] = sum;
        }
}

// ITU-R BT.601: luma, and the differences of blue and red scaled to -0.5..0.5.
glm::vec3 luma_and_chroma(glm::vec3 rgb) {
    const float luma = 0.299F * rgb.r + 0.587F * rgb.g + 0.114F * rgb.b;
    return {luma, (rgb.b - luma) / 1.772F, (rgb.r - luma) / 1.402F};
}

// Light on the sensor as a photo value.
glm::vec3 photo_value(glm::vec3 light, float power) {
    return luma_and_chroma(glm::pow(glm::clamp(light, 0.0F, 1.0F), glm::vec3(power)));
}

// A square of numbers in memory.
struct Square {
    explicit Square(int length) : side(length), values(square(length)) {}

    int side;
    std::vector<glm::vec3> values;

    glm::vec3& at(int x, int y) { return values[index_of(x, y, side)]; }
    const glm::vec3& at(int x, int y) const { return values[index_of(x, y, side)]; }
};

// The sum of what is `distance` px before and after each place, across or down. Zero at the edges
// that it can't reach.
Square both_sides(const Square& from, double distance, bool is_across) {
    Square to(from.side);
    const int whole = static_cast<int>(distance);
    const auto share = static_cast<float>(distance - whole);
    const int reach = whole + 1;
    const int last = from.side - 1;
    for (int y = is_across ? 0 : reach; y <= (is_across ? last : last - reach); ++y)
        for (int x = is_across ? reach : 0; x <= (is_across ? last - reach : last); ++x) {
            const auto sum = [&](int offset) {
                return is_across ? from.at(x - offset, y) + from.at(x + offset, y)
                                 : from.at(x, y - offset) + from.at(x, y + offset);
            };
            to.at(x, y) = (1.0F - share) * sum(whole) + share * sum(whole + 1);
        }
    return to;
}

// What interpolating a Bayer mosaic makes of light, as a mean over the places of the mosaic. With
// the filters of Malvar, He and Cutler 2004, figure 2: sums of the 4 nearest pixels, the 4 diagonal
// ones, and the 4 at a distance of 2. `share`: of this effect, 0 to 1.
void interpolate_mosaic(Square& light, const glm::dmat2& map, float share) {
    const double across = 1.0 / across_scale(map);
    const double down = 1.0 / down_scale(map);
    const Square horizontal = both_sides(light, across, true);
    const Square vertical = both_sides(light, down, false);
    const Square diagonal = both_sides(horizontal, down, false);
    const Square far_horizontal = both_sides(light, 2.0 * across, true);
    const Square far_vertical = both_sides(light, 2.0 * down, false);
    for (std::size_t i = 0; i < light.values.size(); ++i) {
        const glm::vec3 here = light.values[i];
        const glm::vec3 nearest = horizontal.values[i] + vertical.values[i];
        const glm::vec3 corner = diagonal.values[i];
        const glm::vec3 distant = far_horizontal.values[i] + far_vertical.values[i];
        const auto red_or_blue = [&](int own, int other) {
            return 0.25F * here[own] + 0.125F * nearest[own] + 0.0625F * corner[own] +
                   (10.0F * here.g - 2.0F * corner.g - 0.5F * distant.g) / 32.0F +
                   (6.0F * here[other] - 1.5F * distant[other]) / 32.0F;
        };
        const float green = 0.5F * here.g + 0.125F * nearest.g +
                            (4.0F * (here.r + here.b) - distant.r - distant.b) / 32.0F;
        light.values[i] =
            glm::mix(here, glm::vec3(red_or_blue(0, 2), green, red_or_blue(2, 0)), share);
    }
}

constexpr int tile_around = slope_margin + chroma_margin + mosaic_margin;

// Where a camera sees the pixels of a tile: interpolated in a grid, which is exact to 0.001 px
// because the map is smooth.
class TilePlaces {
public:
    TilePlaces(const ScreenMap& map, glm::dvec2 origin, glm::dvec2 size) {
        for (int y = 0; y < nodes; ++y)
            for (int x = 0; x < nodes; ++x) {
                const glm::dvec2 pixel(step * x - tile_around, step * y - tile_around);
                m_nodes[index_of(x, y, nodes)] = map.photo_at((origin + pixel + 0.5) / size);
            }
    }
    glm::dvec2 at(int x, int y) const {
        const int column = (x + tile_around) / step;
        const int row = (y + tile_around) / step;
        const double across = static_cast<double>((x + tile_around) % step) / step;
        const double down = static_cast<double>((y + tile_around) % step) / step;
        return glm::mix(glm::mix(node(column, row), node(column + 1, row), across),
                        glm::mix(node(column, row + 1), node(column + 1, row + 1), across), down);
    }

private:
    static constexpr int step = 4;  // px
    static constexpr int nodes = (SampleLayout::side + 2 * tile_around) / step + 1;
    const glm::dvec2& node(int x, int y) const { return m_nodes[index_of(x, y, nodes)]; }

    std::array<glm::dvec2, static_cast<std::size_t>(nodes* nodes)> m_nodes;
};

bool is_inside(int offset) {
    return offset >= 0 && offset < SampleLayout::side;
}

// The light around each point: a Gaussian of cells that is wide enough to hide a mask.
std::vector<glm::vec3> point_light(const std::vector<glm::vec3>& cells,
                                   const SampleLayout& layout) {
    constexpr double sigma = 1.7;  // cells
    const Kernel kernel = gaussian(sigma, max_reach);
    const auto at = [](const std::vector<glm::vec3>& from, Extent extent, int x, int y) {
        const int column = std::clamp(x, 0, extent.width - 1);
        const int row = std::clamp(y, 0, extent.height - 1);
        return from[index_of(column, row, extent.width)];
    };
    const Extent rows{layout.points.width, layout.cells.height};
    std::vector<glm::vec3> across;
    for (int y = 0; y < rows.height; ++y)
        for (int x = 0; x < rows.width; ++x) {
            glm::vec3 sum(0.0F);
            for (int i = -kernel.reach; i <= kernel.reach; ++i)
                sum += kernel.at(i) * at(cells, layout.cells, 2 * x + i, y);
            across.push_back(sum);
        }
    std::vector<glm::vec3> points;
    for (int y = 0; y < layout.points.height; ++y)
        for (int x = 0; x < rows.width; ++x) {
            glm::vec3 sum(0.0F);
            for (int i = -kernel.reach; i <= kernel.reach; ++i)
                sum += kernel.at(i) * at(across, rows, x, 2 * y + i);
            points.push_back(sum);
        }
    return points;
}

// The derivative between seven numbers at equal distances (sixth order). At an edge, of fewer.
glm::vec3 derivative(const glm::vec3* middle, std::ptrdiff_t stride, int before, int after) {
    const auto difference = [&](std::ptrdiff_t far) {
        return middle[far * stride] - middle[-far * stride];
    };
    const int reach = std::min(before, after);
    if (reach >= 3)
        return (45.0F * difference(1) - 9.0F * difference(2) + difference(3)) / 60.0F;
    if (reach == 2)
        return (8.0F * difference(1) - difference(2)) / 12.0F;
    if (reach == 1)
        return 0.5F * difference(1);
    return before >= 1 ? middle[0] - middle[-stride] : middle[stride] - middle[0];
}

// Derivatives inside a rectangle of numbers at this distance.
void append_slopes(const glm::vec3* values, Extent extent, int margin, float distance,
                   std::vector<glm::vec3>& across, std::vector<glm::vec3>& down) {
    for (int y = margin; y < extent.height - margin; ++y)
        for (int x = margin; x < extent.width - margin; ++x) {
            const glm::vec3* middle = values + index_of(x, y, extent.width);
            across.push_back(derivative(middle, 1, x, extent.width - 1 - x) / distance);
            down.push_back(derivative(middle, extent.width, y, extent.height - 1 - y) / distance);
        }
}

// The values of a tile with a margin for their slopes.
Square developed_tile(const SoftLight& light, const Camera& camera, const SamplePlaces& places,
                      std::size_t tile) {
    const glm::mat3 colour(camera.colour);
    const auto vignette = static_cast<float>(camera.vignette);
    const auto power = static_cast<float>(2.0 / camera.gamma);
    const glm::dmat2& map = places.tile_maps[tile];
    Square seen(blurred_side);
    for (std::size_t i = 0; i < seen.values.size(); ++i) {
        const std::size_t index = tile * seen.values.size() + i;
        seen.values[i] = colour * light.tiles[index] * (1.0F - vignette * places.tile_radii[index]);
    }
    interpolate_mosaic(seen, map, static_cast<float>(camera.mosaic));
    Square sharp(mosaic_side);
    for (int y = 0; y < mosaic_side; ++y)
        for (int x = 0; x < mosaic_side; ++x)
            sharp.at(x, y) = photo_value(seen.at(x + mosaic_margin, y + mosaic_margin), power);
    Square values(value_side);
    convolve(sharp.values.data(), mosaic_side,
             gaussian(camera.chroma_blur / across_scale(map), chroma_margin),
             gaussian(camera.chroma_blur / down_scale(map), chroma_margin), values.values.data(),
             value_side);
    for (int y = 0; y < value_side; ++y)
        for (int x = 0; x < value_side; ++x)
            values.at(x, y).x = sharp.at(x + chroma_margin, y + chroma_margin).x;
    return values;
}

std::vector<glm::vec3> developed_points(const SoftLight& light, const Camera& camera,
                                        const SamplePlaces& places) {
    const glm::mat3 colour(camera.colour);
    const auto vignette = static_cast<float>(camera.vignette);
    const auto power = static_cast<float>(2.0 / camera.gamma);
    std::vector<glm::vec3> points;
    points.reserve(light.points.size());
    for (std::size_t point = 0; point < light.points.size(); ++point)
        points.push_back(photo_value(
            colour * light.points[point] * (1.0F - vignette * places.point_radii[point]), power));
    return points;
}
}  // namespace

SamplePlaces::SamplePlaces(const SampleLayout& layout, const Camera& camera, Extent photo)
    : map(camera, photo) {
    const glm::dvec2 size(layout.picture.width, layout.picture.height);
    for (int tile = 0; tile < layout.tile_count(); ++tile) {
        const glm::dvec2 origin(layout.origin(tile));
        tile_maps.push_back(
            map.slope_at((origin + 0.5 * SampleLayout::side) / size, layout.picture));
        const TilePlaces places(map, origin, size);
        for (int y = -tile_around; y < SampleLayout::side + tile_around; ++y)
            for (int x = -tile_around; x < SampleLayout::side + tile_around; ++x) {
                const glm::dvec2 at = places.at(x, y);
                tile_radii.push_back(static_cast<float>(map.squared_radius(at)));
                if (is_inside(x) && is_inside(y))
                    tiles.push_back(at);
            }
    }
    for (int point = 0; point < layout.point_count(); ++point) {
        const glm::dvec2 place = layout.point(point) / size;
        points.push_back(map.photo_at(place));
        point_radii.push_back(static_cast<float>(map.squared_radius(points.back())));
        point_maps.push_back(map.slope_at(place, layout.picture));
    }
}

SampleValues photographed(const Photo& photo, const SampleLayout& layout,
                          const SamplePlaces& places) {
    SampleValues values;
    values.tiles.reserve(places.tiles.size());
    for (const glm::dvec2 position : places.tiles)
        values.tiles.push_back(luma_and_chroma(photo.at(position)));
    std::vector<glm::vec3> light;
    light.reserve(static_cast<std::size_t>(layout.cell_count()));
    const glm::dvec2 size(layout.picture.width, layout.picture.height);
    for (int cell = 0; cell < layout.cell_count(); ++cell) {
        const int point =
            cell / layout.cells.width / 2 * layout.points.width + cell % layout.cells.width / 2;
        const glm::dmat2 sides = places.point_maps[static_cast<std::size_t>(point)] *
                                 static_cast<double>(layout.cell_side);
        light.push_back(photo.mean_light_at(places.map.photo_at(layout.cell_centre(cell) / size),
                                            sides, layout.cell_side));
    }
    values.points = point_light(light, layout);
    for (glm::vec3& value : values.points)
        value = luma_and_chroma(
            glm::pow(value, glm::vec3(static_cast<float>(2.0 / Photo::mean_gamma))));
    return values;
}

SoftLight blurred(const ScreenLight& light, const Camera& camera, const SampleLayout& layout,
                  const SamplePlaces& places) {
    SoftLight result;
    result.points = point_light(light.cells, layout);
    const auto tiles = static_cast<std::size_t>(layout.tile_count());
    result.tiles.resize(tiles * square(blurred_side));
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        const Kernel across = lens_kernel(camera, across_scale(places.tile_maps[tile]));
        const Kernel down = lens_kernel(camera, down_scale(places.tile_maps[tile]));
        convolve(&light.tiles[tile * square(SampleLayout::stride)], SampleLayout::stride, across,
                 down, &result.tiles[tile * square(blurred_side)], blurred_side);
    }
    return result;
}

SampleValues developed(const SoftLight& light, const Camera& camera, const SampleLayout& layout,
                       const SamplePlaces& places) {
    SampleValues values;
    const auto tiles = static_cast<std::size_t>(layout.tile_count());
    values.tiles.reserve(tiles * square(SampleLayout::side));
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        const Square with_margin = developed_tile(light, camera, places, tile);
        for (int y = 0; y < SampleLayout::side; ++y)
            for (int x = 0; x < SampleLayout::side; ++x)
                values.tiles.push_back(with_margin.at(x + slope_margin, y + slope_margin));
    }
    values.points = developed_points(light, camera, places);
    return values;
}

SampleSlopes developed_slopes(const SoftLight& light, const Camera& camera,
                              const SampleLayout& layout, const SamplePlaces& places) {
    SampleSlopes slopes;
    for (int tile = 0; tile < layout.tile_count(); ++tile)
        append_slopes(
            developed_tile(light, camera, places, static_cast<std::size_t>(tile)).values.data(),
            {value_side, value_side}, slope_margin, 1.0F, slopes.across.tiles, slopes.down.tiles);
    append_slopes(developed_points(light, camera, places).data(), layout.points, 0,
                  static_cast<float>(layout.point_distance()), slopes.across.points,
                  slopes.down.points);
    return slopes;
}
