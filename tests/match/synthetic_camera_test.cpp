// The synthetic camera, compared with closed forms.
#include "match/synthetic_camera.h"

#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace {
constexpr double half_step = 0.5 / 255.0;  // of 8 bits

using Corners = std::array<glm::dvec2, 4>;

Picture drawn_screen(Extent extent, const std::function<glm::vec3(int, int)>& color) {
    Picture screen{extent, 3, Encoding::linear, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            const glm::vec3 pixel = color(x, y);
            screen.pixels.insert(screen.pixels.end(), {pixel.r, pixel.g, pixel.b});
        }
    return screen;
}

Picture uniform_screen(glm::vec3 color) {
    return drawn_screen({4, 3}, [color](int, int) { return color; });
}

/// A camera whose photo is the light of the screen, without losses.
SyntheticCamera plain_camera(const Corners& corners) {
    SyntheticCamera camera{.corners = corners};
    camera.noise = 0.0;
    camera.vignette = 0.0;
    camera.gain = 1.0;
    camera.gamma = 1.0;
    camera.has_bayer = false;
    return camera;
}

/// A screen that is larger than a photo of this size.
Corners filled(Extent photo) {
    const double right = photo.width + 50.0, bottom = photo.height + 50.0;
    return {{{-50.0, -50.0}, {right, -50.0}, {right, bottom}, {-50.0, bottom}}};
}

double value(const Picture& photo, int x, int y, std::size_t channel = 0) {
    return static_cast<double>(photo.pixels[photo.index(x, y) + channel]);
}

/// The photo between its pixels, interpolated.
double value_at(const Picture& photo, glm::dvec2 point) {
    const glm::dvec2 corner = glm::floor(point - 0.5);
    const glm::dvec2 part = point - 0.5 - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    return glm::mix(glm::mix(value(photo, x, y), value(photo, x + 1, y), part.x),
                    glm::mix(value(photo, x, y + 1), value(photo, x + 1, y + 1), part.x), part.y);
}

/// The signed distance from a point to where the light crosses one half, along a unit vector, at
/// most 4 px; 4: no crossing.
double half_light_distance(const Picture& photo, glm::dvec2 point, glm::dvec2 along) {
    constexpr double step = 0.05;
    double before = value_at(photo, point - 4.0 * along);
    for (int i = 1; i <= 160; ++i) {
        const double distance = -4.0 + i * step;
        const double after = value_at(photo, point + distance * along);
        if ((before - 0.5) * (after - 0.5) <= 0.0 && before != after)
            return distance - step * (after - 0.5) / (after - before);
        before = after;
    }
    return 4.0;
}

/// The largest distance from a screen's edges to their half-light crossings. `straight`: corners
/// before distortion; `seen`: the formula of the lens.
double largest_edge_error(const Picture& photo, const Corners& straight,
                          const std::function<glm::dvec2(glm::dvec2)>& seen) {
    double largest = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
        for (double part = 0.1; part < 0.95; part += 0.05) {
            const auto at = [&](double t) {
                return seen(glm::mix(straight[i], straight[(i + 1) % 4], t));
            };
            const glm::dvec2 along = glm::normalize(at(part + 0.001) - at(part - 0.001));
            const double error = half_light_distance(photo, at(part), {along.y, -along.x});
            largest = std::max(largest, std::abs(error));
        }
    return largest;
}

/// The mean of the normal distribution's integral over a pixel with this distance of its centre.
double blurred_edge(double distance, double blur) {
    const auto integral = [blur](double x) {
        const double z = x / blur;
        return x * 0.5 * (1.0 + std::erf(z / std::numbers::sqrt2)) +
               blur * std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    };
    return integral(distance + 0.5) - integral(distance - 0.5);
}

double variance(const Picture& photo) {
    double sum = 0.0, squares = 0.0;
    for (const float value : photo.pixels) {
        sum += static_cast<double>(value);
        squares += static_cast<double>(value) * static_cast<double>(value);
    }
    const auto count = static_cast<double>(photo.pixels.size());
    return squares / count - sum / count * (sum / count);
}

constexpr Extent small_photo{120, 90};
const Corners tilted{{{19.3, 12.6}, {101.7, 20.2}, {95.4, 78.9}, {14.2, 70.5}}};
}  // namespace

TEST_CASE("a photo of white has the gain, the vignette and the gamma of the formula") {
    SyntheticCamera camera = plain_camera(filled(small_photo));
    camera.gain = 0.8;
    camera.vignette = 0.25;
    camera.gamma = 2.2;
    const Picture photo = photograph(uniform_screen(glm::vec3(1.0f)), camera, small_photo);

    CHECK(photo.extent == small_photo);
    CHECK(photo.channels == 3);
    CHECK(photo.encoding == Encoding::display);
    double largest = 0.0;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x) {
            const double r = std::hypot(x + 0.5 - 60.0, y + 0.5 - 45.0) / 75.0;
            const double expected = std::pow(0.8 * (1.0 - 0.25 * r * r), 1.0 / 2.2);
            for (std::size_t c = 0; c < 3; ++c)
                largest = std::max(largest, std::abs(value(photo, x, y, c) - expected));
        }
    CHECK(largest < half_step + 1e-5);
}

TEST_CASE("the edges of a screen in perspective lie between its corners") {
    const Picture photo =
        photograph(uniform_screen(glm::vec3(1.0f)), plain_camera(tilted), small_photo);

    CHECK(largest_edge_error(photo, tilted, [](glm::dvec2 point) { return point; }) < 0.1);
    CHECK(value(photo, 2, 2) == 0.0);
    CHECK(value(photo, 60, 45) == 1.0);
}

TEST_CASE("upright edges between pixels lie where the corners are") {
    const Corners upright{{{20.2, 15.4}, {90.7, 15.4}, {90.7, 70.9}, {20.2, 70.9}}};
    for (const double blur : {0.7, 1.3}) {
        CAPTURE(blur);
        SyntheticCamera camera = plain_camera(upright);
        camera.blur = blur;
        const Picture photo = photograph(uniform_screen(glm::vec3(1.0f)), camera, small_photo);
        CHECK(largest_edge_error(photo, upright, [](glm::dvec2 point) { return point; }) < 0.05);
    }
}

TEST_CASE("a lens bends the edges of a screen and keeps its corners") {
    for (const double lens : {-0.12, -0.03, 0.05, 0.2}) {
        CAPTURE(lens);
        const auto seen = [lens](glm::dvec2 point) {
            const glm::dvec2 r = (point - glm::dvec2(60.0, 45.0)) / 75.0;
            return glm::dvec2(60.0, 45.0) + r * (1.0 + lens * glm::dot(r, r)) * 75.0;
        };
        SyntheticCamera camera = plain_camera({});
        std::transform(tilted.begin(), tilted.end(), camera.corners.begin(), seen);
        camera.lens = lens;
        const Picture photo = photograph(uniform_screen(glm::vec3(1.0f)), camera, small_photo);
        CHECK(largest_edge_error(photo, tilted, seen) < 0.1);
    }
}

TEST_CASE("the first corner is the screen's top left, and the others follow clockwise") {
    const Picture screen = drawn_screen({40, 20}, [](int x, int y) {
        return glm::vec3(x < 20 && y < 10, x >= 20 && y < 10, x >= 20 && y >= 10);
    });
    const Picture photo = photograph(screen, plain_camera(tilted), small_photo);
    const glm::dvec2 middle = (tilted[0] + tilted[1] + tilted[2] + tilted[3]) / 4.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 near_corner = glm::mix(tilted[i], middle, 0.4);
        for (std::size_t c = 0; c < 3; ++c)
            CHECK(value(photo, int(near_corner.x), int(near_corner.y), c) == (c == i ? 1.0 : 0.0));
    }
}

TEST_CASE("the middle of a screen in perspective lies where its diagonals cross") {
    const Corners steep{{{20.0, 15.0}, {100.0, 35.0}, {100.0, 55.0}, {20.0, 80.0}}};
    const glm::dvec2 falling = steep[2] - steep[0], rising = steep[1] - steep[3];
    const glm::dvec2 side = steep[3] - steep[0];
    const double part =
        (side.x * rising.y - side.y * rising.x) / (falling.x * rising.y - falling.y * rising.x);
    const glm::dvec2 middle = steep[0] + part * falling;
    const auto light_of_left = [](int x, int) { return glm::vec3(x < 30); };
    const auto light_of_top = [](int, int y) { return glm::vec3(y < 20); };
    const SyntheticCamera camera = plain_camera(steep);
    const Picture left = photograph(drawn_screen({60, 40}, light_of_left), camera, small_photo);
    const Picture top = photograph(drawn_screen({60, 40}, light_of_top), camera, small_photo);

    CHECK(std::abs(half_light_distance(left, middle, {1.0, 0.0})) < 0.1);
    CHECK(std::abs(half_light_distance(top, middle, {0.0, 1.0})) < 0.1);
}

TEST_CASE("the blur of an edge is the integral of a Gaussian") {
    for (const double blur : {0.5, 1.3, 2.4}) {
        CAPTURE(blur);
        Corners corners = filled(small_photo);
        corners[0].x = corners[3].x = 60.3;
        SyntheticCamera camera = plain_camera(corners);
        camera.blur = blur;
        const Picture photo = photograph(uniform_screen(glm::vec3(1.0f)), camera, small_photo);
        double largest = 0.0;
        for (int x = 0; x < 120; ++x)
            largest = std::max(largest,
                               std::abs(value(photo, x, 45) - blurred_edge(x + 0.5 - 60.3, blur)));
        CHECK(largest < half_step + 0.003);
    }
}

TEST_CASE("light from outside the photo blurs into it") {
    Corners corners = filled(small_photo);
    corners[1].x = corners[2].x = 0.0;
    const Picture photo =
        photograph(uniform_screen(glm::vec3(1.0f)), plain_camera(corners), small_photo);

    CHECK(std::abs(value(photo, 0, 45) - (1.0 - blurred_edge(0.5, 1.3))) < half_step + 0.002);
}

TEST_CASE("lines finer than the photo's pixels become their mean") {
    const Picture screen =
        drawn_screen({714, 530}, [](int x, int) { return glm::vec3(x % 2 == 0); });
    const Corners corners{{{1.0, 1.0}, {118.0, 3.0}, {119.0, 88.0}, {2.0, 89.0}}};
    const Picture photo = photograph(screen, plain_camera(corners), small_photo);
    double largest = 0.0;
    for (int y = 20; y < 70; ++y)
        for (int x = 20; x < 100; ++x)
            largest = std::max(largest, std::abs(value(photo, x, y) - 0.5));
    CHECK(largest < 0.01);
}

TEST_CASE("noise has the variance of the formula in every light") {
    for (const float light : {0.6f, 0.15f, 0.012f}) {
        CAPTURE(light);
        SyntheticCamera camera = plain_camera(filled(small_photo));
        camera.noise = 0.02;
        const Picture photo = photograph(uniform_screen(glm::vec3(light)), camera, small_photo);
        const double rounding = 1.0 / (12.0 * 255.0 * 255.0);
        const double expected = 0.0004 * std::max(static_cast<double>(light), 0.02) + rounding;
        CHECK(std::abs(variance(photo) / expected - 1.0) < 0.04);
    }
}

TEST_CASE("noise depends only on its seed") {
    SyntheticCamera camera{.corners = tilted};
    const Picture screen = uniform_screen(glm::vec3(0.5f));
    const Picture photo = photograph(screen, camera, small_photo);

    CHECK(photograph(screen, camera, small_photo) == photo);
    camera.seed = 2;
    CHECK_FALSE(photograph(screen, camera, small_photo) == photo);
}

TEST_CASE("the colour matrix mixes the channels of the screen") {
    SyntheticCamera camera = plain_camera(filled(small_photo));
    camera.colour = glm::transpose(glm::dmat3(0.7, 0.2, 0.1,     // red
                                              0.1, 0.8, -0.05,   // green
                                              0.0, 0.25, 0.6));  // blue
    const Picture photo = photograph(uniform_screen({0.2f, 0.5f, 0.9f}), camera, small_photo);

    CHECK(std::abs(value(photo, 60, 45, 0) - 0.33) < half_step + 1e-5);
    CHECK(std::abs(value(photo, 60, 45, 1) - 0.375) < half_step + 1e-5);
    CHECK(std::abs(value(photo, 60, 45, 2) - 0.665) < half_step + 1e-5);
}

TEST_CASE("a Bayer mosaic keeps a uniform colour, also at the borders") {
    SyntheticCamera camera = plain_camera(filled(small_photo));
    const Picture screen = uniform_screen({0.2f, 0.5f, 0.9f});
    const Picture direct = photograph(screen, camera, small_photo);
    camera.has_bayer = true;

    CHECK(photograph(screen, camera, small_photo) == direct);
}

TEST_CASE("each pixel of a Bayer mosaic keeps the channel of its own filter") {
    const Picture screen = drawn_screen({60, 45}, [](int x, int y) {
        return glm::vec3(x % 5, y % 4, (x + y) % 3) / glm::vec3(5.0f, 4.0f, 3.0f);
    });
    SyntheticCamera camera = plain_camera(tilted);
    const Picture direct = photograph(screen, camera, small_photo);
    camera.has_bayer = true;
    const Picture photo = photograph(screen, camera, small_photo);
    std::array<int, 3> equal{}, own{};
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x) {
            const std::size_t filter = y % 2 == 0 ? (x % 2 == 0 ? 0 : 1) : (x % 2 == 0 ? 1 : 2);
            for (std::size_t c = 0; c < 3; ++c) {
                const bool is_equal = value(photo, x, y, c) == value(direct, x, y, c);
                (c == filter ? own : equal)[c] += is_equal ? 1 : 0;
            }
        }
    CHECK(own == std::array{2700, 5400, 2700});
    for (const int count : equal)
        CHECK(count < 6000);  // black surrounds the screen; on it the other channels differ
}

TEST_CASE("a photo is written as a JPEG file, and a missing folder is reported") {
    const TemporaryFolder folder;
    const Picture photo =
        photograph(uniform_screen(glm::vec3(0.5f)), {.corners = tilted}, small_photo);

    REQUIRE(save_jpeg(photo, folder / "low.jpg", 50));
    REQUIRE(save_jpeg(photo, folder / "high.jpg", 95));
    const std::string low = content_of(folder / "low.jpg");
    CHECK(low.starts_with("\xFF\xD8\xFF"));
    CHECK(low.size() < content_of(folder / "high.jpg").size());
    CHECK_FALSE(save_jpeg(photo, folder / "missing/photo.jpg", 50));
}
