#include "match/synthetic_camera.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace {
// Light is sampled in cells, which are smaller than the photo's pixels: this many per pixel in each
// direction.
constexpr int cells = 3;

std::size_t size(int count) {
    return static_cast<std::size_t>(count);
}

/// Radial distortion of the first order, and the measure of distance that it uses.
struct Lens {
    glm::dvec2 centre;
    double half_diagonal;
    double k1;

    double squared_radius(glm::dvec2 photo_point) const {
        const glm::dvec2 r = (photo_point - centre) / half_diagonal;
        return glm::dot(r, r);
    }
    std::optional<glm::dvec2> undistorted(glm::dvec2 seen) const;
};

Lens lens_of(const SyntheticCamera& camera, Extent photo) {
    const glm::dvec2 size(photo.width, photo.height);
    return {size / 2.0, glm::length(size) / 2.0, camera.lens};
}

/// The point without distortion. None: the lens shows no point there.
std::optional<glm::dvec2> Lens::undistorted(glm::dvec2 seen) const {
    // With scale = undistorted distance / seen distance: scale + q scale^3 = 1.
    const double q = k1 * squared_radius(seen);
    if (q <= -4.0 / 27.0)
        return std::nullopt;
    double scale = 1.0 / (1.0 + q);
    for (int i = 0; i < 50; ++i) {  // Newton; usually 2 or 3 steps
        const double step =
            (scale + q * scale * scale * scale - 1.0) / (1.0 + 3.0 * q * scale * scale);
        scale -= step;
        if (std::abs(step) < 1e-6)  // the error is the square of that
            break;
    }
    return centre + (seen - centre) * scale;
}

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// The homography from the unit square to a convex quadrilateral. Heckbert 1989, "Fundamentals of
/// texture mapping and image warping", section 2.2.3.
glm::dmat3 square_to_quad(const std::array<glm::dvec2, 4>& quad) {
    const glm::dvec2 sum = quad[0] - quad[1] + quad[2] - quad[3];
    const glm::dvec2 right = quad[1] - quad[2];
    const glm::dvec2 bottom = quad[3] - quad[2];
    const double determinant = cross(right, bottom);
    const double g = cross(sum, bottom) / determinant;
    const double h = cross(right, sum) / determinant;
    return glm::dmat3(glm::dvec3(quad[1] - quad[0] + g * quad[1], g),
                      glm::dvec3(quad[3] - quad[0] + h * quad[3], h), glm::dvec3(quad[0], 1.0));
}

/// Where the points of the photo lie on the screen.
struct View {
    Lens lens;
    glm::dmat3 to_screen;  // from undistorted photo pixels to screen pixels

    std::optional<glm::dvec2> screen_point(glm::dvec2 seen) const {
        const auto straight = lens.undistorted(seen);
        if (!straight)
            return std::nullopt;
        const glm::dvec3 point = to_screen * glm::dvec3(*straight, 1.0);
        if (point.z <= 0.0)  // beyond the horizon of the screen's plane
            return std::nullopt;
        return glm::dvec2(point) / point.z;
    }
};

View view_of(const SyntheticCamera& camera, Extent photo, Extent screen) {
    const Lens lens = lens_of(camera, photo);
    std::array<glm::dvec2, 4> straight;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto corner = lens.undistorted(camera.corners[i]);
        assert(corner.has_value());
        straight[i] = corner.value_or(camera.corners[i]);
    }
    glm::dmat3 size(1.0);
    size[0][0] = screen.width;
    size[1][1] = screen.height;
    return {lens, size * glm::inverse(square_to_quad(straight))};
}

/// The pixel of the screen at a point, interpolated; the pixels at its edges continue outwards.
glm::vec3 interpolated(const Picture& screen, glm::dvec2 point) {
    const double x = std::clamp(point.x - 0.5, 0.0, screen.extent.width - 1.0);
    const double y = std::clamp(point.y - 0.5, 0.0, screen.extent.height - 1.0);
    const auto left = static_cast<int>(x);
    const auto top = static_cast<int>(y);
    const int right = std::min(left + 1, screen.extent.width - 1);
    const int bottom = std::min(top + 1, screen.extent.height - 1);
    const auto across = static_cast<float>(x - left);
    const auto down = static_cast<float>(y - top);
    const float* corner[] = {
        &screen.pixels[screen.index(left, top)], &screen.pixels[screen.index(right, top)],
        &screen.pixels[screen.index(left, bottom)], &screen.pixels[screen.index(right, bottom)]};
    glm::vec3 light;
    for (int c = 0; c < 3; ++c) {
        const float upper = corner[0][c] + (corner[1][c] - corner[0][c]) * across;
        const float lower = corner[2][c] + (corner[3][c] - corner[2][c]) * across;
        light[c] = upper + (lower - upper) * down;
    }
    return light;
}

/// The share of a sample that lies on the screen, 0..1. `width`: of the sample, screen pixels.
float coverage(glm::dvec2 point, glm::dvec2 width, glm::dvec2 screen) {
    double share = 1.0;
    for (int i = 0; i < 2; ++i)
        share *= std::clamp(point[i] / width[i] + 0.5, 0.0, 1.0) *
                 std::clamp((screen[i] - point[i]) / width[i] + 0.5, 0.0, 1.0);
    return static_cast<float>(share);
}

/// A cell of the photo on the screen: screen pixels.
struct Cell {
    glm::dvec2 centre;
    glm::dvec2 across;  // from its left edge to its right one
    glm::dvec2 down;    // from its upper edge to its lower one
};

/// The mean light in a cell, from at least two samples per screen pixel.
glm::vec3 mean_light(const Picture& screen, const Cell& cell) {
    const glm::dvec2 size(screen.extent.width, screen.extent.height);
    const glm::dvec2 reach = glm::abs(cell.across) + glm::abs(cell.down);
    if (glm::any(glm::lessThan(cell.centre + reach, glm::dvec2(0.0))) ||
        glm::any(glm::greaterThan(cell.centre - reach, size)))
        return glm::vec3(0.0f);
    const bool is_inside = glm::all(glm::greaterThan(cell.centre - reach, glm::dvec2(0.0))) &&
                           glm::all(glm::lessThan(cell.centre + reach, size));
    const double longer = std::max(glm::length(cell.across), glm::length(cell.down));
    const int count = static_cast<int>(std::clamp(std::ceil(2.0 * longer), 1.0, 32.0));
    if (count == 1 && is_inside)
        return interpolated(screen, cell.centre);
    glm::vec3 sum(0.0f);
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 point = cell.centre + cell.across * ((i + 0.5) / count - 0.5) +
                                     cell.down * ((j + 0.5) / count - 0.5);
            const float share = is_inside ? 1.0f : coverage(point, reach / double(count), size);
            if (share > 0.0f)
                sum += interpolated(screen, point) * share;
        }
    return sum / static_cast<float>(count * count);
}

/// How much a pixel of the sensor receives from the cells around it, in one direction. It is the
/// blur of the lens, averaged over the pixel.
struct Response {
    int margin = 0;              // pixels around the photo whose light reaches it
    std::vector<float> weights;  // of the cells of 2 * margin + 1 pixels; their sum is 1
};

Response response_of(double blur) {
    Response response;
    response.margin = static_cast<int>(std::ceil(4.0 * blur));
    const double scale = 1.0 / (std::max(blur, 1e-6) * std::numbers::sqrt2);
    const int count = cells * (2 * response.margin + 1);
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double distance = (i + 0.5 - count / 2.0) / cells;
        weights.push_back(std::erf((distance + 0.5) * scale) - std::erf((distance - 0.5) * scale));
        sum += weights.back();
    }
    for (const double weight : weights)
        response.weights.push_back(static_cast<float>(weight / sum));
    return response;
}

using Points = std::vector<std::optional<glm::dvec2>>;

/// The points of the screen at one row of the cells' corners. `row`: from the top of the margin.
void find_points(const View& view, int row, int margin, Points& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = view.screen_point(glm::dvec2(static_cast<double>(i), static_cast<double>(row)) /
                                          double(cells) -
                                      double(margin));
}

/// The light in a row of cells between two rows of corners.
void draw_cells(const Picture& screen, const Points& upper, const Points& lower,
                std::vector<glm::vec3>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = glm::vec3(0.0f);
        if (!upper[i] || !upper[i + 1] || !lower[i] || !lower[i + 1])
            continue;
        const glm::dvec2 left = *lower[i] + *upper[i];
        const glm::dvec2 right = *lower[i + 1] + *upper[i + 1];
        const glm::dvec2 down = (*lower[i] + *lower[i + 1]) - (*upper[i] + *upper[i + 1]);
        row[i] = mean_light(screen, {(left + right) * 0.25, (right - left) * 0.5, down * 0.5});
    }
}

/// The pixels of a row, blurred horizontally: three floats each.
void blur_row(const std::vector<glm::vec3>& row, const Response& response, float* pixels,
              int width) {
    for (int x = 0; x < width; ++x) {
        const glm::vec3* cell = &row[size(x * cells)];
        float red = 0.0f, green = 0.0f, blue = 0.0f;
        for (const float weight : response.weights) {
            red += cell->r * weight;
            green += cell->g * weight;
            blue += cell->b * weight;
            ++cell;
        }
        *pixels++ = red;
        *pixels++ = green;
        *pixels++ = blue;
    }
}

/// Linear light of the screen on the sensor, through the lens.
Picture optical_image(const Picture& screen, const SyntheticCamera& camera, Extent photo) {
    const View view = view_of(camera, photo, screen.extent);
    const Response response = response_of(camera.blur);
    const int columns = cells * (photo.width + 2 * response.margin);
    const int rows = cells * (photo.height + 2 * response.margin);
    const std::size_t stride = size(photo.width) * 3;
    std::vector<float> blurred(stride * size(rows));
    std::vector<glm::vec3> row(size(columns));
    Points upper(size(columns + 1)), lower(size(columns + 1));
    find_points(view, 0, response.margin, upper);
    for (int y = 0; y < rows; ++y) {
        find_points(view, y + 1, response.margin, lower);
        draw_cells(screen, upper, lower, row);
        blur_row(row, response, &blurred[stride * size(y)], photo.width);
        std::swap(upper, lower);
    }
    Picture image{photo, 3, Encoding::linear, std::vector<float>(stride * size(photo.height))};
    for (int y = 0; y < photo.height; ++y)
        for (std::size_t i = 0; i < response.weights.size(); ++i) {
            const float weight = response.weights[i];
            const float* from = &blurred[stride * (size(y * cells) + i)];
            float* to = &image.pixels[stride * size(y)];
            for (std::size_t x = 0; x < stride; ++x)
                to[x] += from[x] * weight;
        }
    return image;
}

/// The noise of the sensor: normal, the same sequence with every standard library.
class Noise {
public:
    explicit Noise(const SyntheticCamera& camera) : m_random(camera.seed), m_noise(camera.noise) {}
    float noisy(float light) {
        const double deviation = m_noise * std::sqrt(std::max(static_cast<double>(light), 0.02));
        return light + static_cast<float>(deviation * normal());
    }

private:
    double uniform() { return (static_cast<double>(m_random()) + 0.5) / 4294967296.0; }
    double normal() {  // Box and Muller 1958
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }

    std::mt19937 m_random;
    double m_noise;
};

/// Changes the light of the screen to that of the camera: colours, gain and vignette.
void expose(Picture& image, const SyntheticCamera& camera) {
    const Lens lens = lens_of(camera, image.extent);
    const glm::mat3 colour(camera.colour * camera.gain);
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x) {
            float* pixel = &image.pixels[image.index(x, y)];
            const double loss = camera.vignette * lens.squared_radius({x + 0.5, y + 0.5});
            const glm::vec3 light = colour * glm::vec3(pixel[0], pixel[1], pixel[2]) *
                                    static_cast<float>(std::max(1.0 - loss, 0.0));
            for (int c = 0; c < 3; ++c)
                pixel[c] = light[c];
        }
}

constexpr int border = 2;  // of the mosaic, for the 5x5 filters

/// An index in 0 .. count - 1, mirrored at the centres of the first and last pixel.
int mirrored(int i, int count) {
    while (i < 0 || i >= count)
        i = i < 0 ? -i : 2 * (count - 1) - i;
    return i;
}

/// The values of the RGGB mosaic: one channel, with a mirrored border.
Picture mosaic_of(const Picture& image, Noise& noise) {
    const auto [width, height] = image.extent;
    Picture mosaic{{width + 2 * border, height + 2 * border}, 1, Encoding::linear, {}};
    mosaic.pixels.resize(mosaic.index(0, mosaic.extent.height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            mosaic.pixels[mosaic.index(x + border, y + border)] =
                noise.noisy(image.pixels[image.index(x, y) + size(x % 2 + y % 2)]);
    for (int y = 0; y < mosaic.extent.height; ++y)
        for (int x = 0; x < mosaic.extent.width; ++x)
            mosaic.pixels[mosaic.index(x, y)] = mosaic.pixels[mosaic.index(
                mirrored(x - border, width) + border, mirrored(y - border, height) + border)];
    return mosaic;
}

/// The three channels at a pixel of the mosaic. `is_red_row`: the row has red and green.
void interpolate_mosaic(const float* p, std::ptrdiff_t row, bool is_green, bool is_red_row,
                        float* pixel) {
    const float beside = p[-1] + p[1], above = p[-row] + p[row];
    const float far_beside = p[-2] + p[2], far_above = p[-2 * row] + p[2 * row];
    const float diagonal = p[-row - 1] + p[-row + 1] + p[row - 1] + p[row + 1];
    if (is_green) {
        const float own = 5.0f * p[0] - diagonal;
        const float of_row = (own + 4.0f * beside - far_beside + 0.5f * far_above) / 8.0f;
        const float of_column = (own + 4.0f * above - far_above + 0.5f * far_beside) / 8.0f;
        pixel[0] = is_red_row ? of_row : of_column;
        pixel[1] = p[0];
        pixel[2] = is_red_row ? of_column : of_row;
        return;
    }
    const float other = (6.0f * p[0] + 2.0f * diagonal - 1.5f * (far_beside + far_above)) / 8.0f;
    pixel[0] = is_red_row ? p[0] : other;
    pixel[1] = (4.0f * p[0] + 2.0f * (beside + above) - far_beside - far_above) / 8.0f;
    pixel[2] = is_red_row ? other : p[0];
}

/// Records the image with a Bayer mosaic and interpolates it.
void record_mosaic(Picture& image, Noise& noise) {
    const Picture mosaic = mosaic_of(image, noise);
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x)
            interpolate_mosaic(&mosaic.pixels[mosaic.index(x + border, y + border)],
                               mosaic.extent.width, (x + y) % 2 == 1, y % 2 == 0,
                               &image.pixels[image.index(x, y)]);
}
}  // namespace

Picture photograph(const Picture& screen, const SyntheticCamera& camera, Extent photo) {
    assert(!photo.is_empty() && !screen.extent.is_empty() && screen.channels >= 3);
    assert(screen.encoding == Encoding::linear);
    Picture image = optical_image(screen, camera, photo);
    expose(image, camera);
    Noise noise(camera);
    if (camera.has_bayer && photo.width > 1 && photo.height > 1)
        record_mosaic(image, noise);
    else
        for (float& light : image.pixels)
            light = noise.noisy(light);
    const auto exponent = static_cast<float>(1.0 / camera.gamma);
    for (float& value : image.pixels)
        value = std::round(std::pow(std::clamp(value, 0.0f, 1.0f), exponent) * 255.0f) / 255.0f;
    image.encoding = Encoding::display;
    return image;
}

bool save_jpeg(const Picture& photo, const std::filesystem::path& file, int quality) {
    const auto output = OIIO::ImageOutput::create("jpeg");
    if (!output)
        return false;
    OIIO::ImageSpec spec(photo.extent.width, photo.extent.height, photo.channels,
                         OIIO::TypeDesc::UINT8);
    spec.attribute("Compression", "jpeg:" + std::to_string(quality));
    spec.attribute("jpeg:subsampling", "4:2:0");
    std::vector<std::uint8_t> bytes;
    bytes.reserve(photo.pixels.size());
    for (const float value : photo.pixels)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(value * 255.0f)));
    const bool is_written = output->open(file.string(), spec) &&
                            output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) &&
                            output->close();
    if (!is_written)
        output->geterror();  // otherwise OpenImageIO prints it
    return is_written;
}
