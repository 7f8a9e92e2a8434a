// Caffeine compared with closed forms and brute force: sample points, lamp, surfaces, and the
// convergence of its error.
#include "looks/path_tracer.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <array>
#include <numbers>
#include <numeric>
#include <set>

namespace {
constexpr double pi = std::numbers::pi;

PathTracer tracer(PathTracer::Settings settings, Extent size = {8, 8}, int batch = 64) {
    auto made = PathTracer::create(std::move(settings), size, batch);
    REQUIRE_MESSAGE(made.has_value(), problems_of(made));
    return std::move(*made);
}

double mean_of(const std::vector<double>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) /
           static_cast<double>(numbers.size());
}

using Point = std::array<double, 3>;

Point unit(const Point& p) {
    const double length = std::hypot(p[0], p[1], p[2]);
    return {p[0] / length, p[1] / length, p[2] / length};
}

/// Only the coffee, at y = 5 above the whole molecule, seen at its centre at 45 degrees. The lamp
/// of radius 3 and brightness 1 is 10 above it, or 10 away in the mirror direction.
struct Plane {
    bool is_lamp_mirrored = false;
    double roughness = 1.0;
    double matt = 1.0;

    PathTracer::Settings settings() const {
        const char* side = is_lamp_mirrored ? "7.0710678" : "0";
        const char* height = is_lamp_mirrored ? "12.0710678" : "15";
        return {{"coffee_height", "5"},
                {"coffee_color", "1,1,1"},
                {"camera_place", "0,15,10"},
                {"camera_target", "0,5,0"},
                {"field_of_view", "1"},
                {"aperture", "0"},
                {"light_angle", "-1.5707963"},
                {"light_distance", side},
                {"light_height", height},
                {"light_radius", "3"},
                {"light_color", "1,1,1"},
                {"light_intensity", "1"},
                {"ambient", "0,0,0"},
                {"bounces", "0"},
                {"coffee_roughness", std::to_string(roughness)},
                {"coffee_matt", std::to_string(matt)}};
    }
    /// The lamp's share of the directions sampled by the article's lobe: brute force over uniform
    /// points of its sphere.
    double lamp_share() const {
        const Point mirrored{0.0, std::sqrt(0.5), -std::sqrt(0.5)};
        const Point axis = is_lamp_mirrored ? mirrored : Point{0.0, 1.0, 0.0};
        const double cosine = std::sqrt(1.0 - 0.09);
        constexpr int steps = 400;
        int met = 0;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                const double z = 1.0 - 2.0 * (i + 0.5) / steps;
                const double around = 2.0 * pi * (j + 0.5) / steps;
                const double flat = std::sqrt(1.0 - z * z);
                const Point sphere{flat * std::cos(around), z, flat * std::sin(around)};
                Point towards{};
                for (std::size_t k = 0; k < 3; ++k)
                    towards[k] = (1.0 - roughness) * mirrored[k] +
                                 roughness * (sphere[k] + (k == 1 ? 1.0 : 0.0));
                const Point direction = unit(towards);
                met += direction[0] * axis[0] + direction[1] * axis[1] + direction[2] * axis[2] >=
                       cosine;
            }
        return static_cast<double>(met) / (steps * steps);
    }
};

constexpr double radiance = 6.0;  // of the article's lamp at brightness 1

double light_of(const Plane& plane, int samples = 512) {
    return mean_of(tracer(plane.settings()).light_after(samples));
}
}  // namespace

TEST_CASE("each dimension of the first 2^k points is stratified, and the first two fill each box") {
    PathTracer empty = tracer({});
    empty.light_after(64);
    const Picture points = empty.target("points");
    REQUIRE(points.extent == Extent{5, 16384});
    const auto number = [&](int index, int dimension) {
        const std::size_t texel = points.index(dimension / 4, points.extent.height - 1 - index);
        return static_cast<double>(points.pixels[texel + static_cast<std::size_t>(dimension % 4)]);
    };
    for (int dimension = 0; dimension < 20; ++dimension)
        for (const int count : {2, 64, 1024, 16384}) {
            CAPTURE(dimension);
            CAPTURE(count);
            std::set<int> places;
            for (int i = 0; i < count; ++i)
                places.insert(static_cast<int>(number(i, dimension) * count));
            CHECK(places.size() == static_cast<std::size_t>(count));
        }
    for (int wide = 1; wide <= 256; wide *= 2) {
        std::set<std::pair<int, int>> boxes;
        for (int i = 0; i < 256; ++i)
            boxes.insert({static_cast<int>(number(i, 0) * wide),
                          static_cast<int>(number(i, 1) * 256 / wide)});
        CHECK(boxes.size() == 256);
    }
}

TEST_CASE("a matt plane under a spherical lamp has the light of the closed form") {
    // E = pi L (r / d)^2 for a sphere overhead (view factor of a sphere); E / pi is reflected.
    const double expected = radiance * 0.09;
    CHECK(std::abs(light_of({.roughness = 0.0, .matt = 1.0}) / expected - 1.0) < 0.003);
    CHECK(std::abs(light_of({.roughness = 1.0, .matt = 0.0}) / expected - 1.0) < 0.003);
}

TEST_CASE("a mirror shows the lamp unchanged") {
    CHECK(std::abs(light_of({.is_lamp_mirrored = true, .roughness = 0.0, .matt = 0.0}) / radiance -
                   1.0) < 1e-5);
    CHECK(light_of({.is_lamp_mirrored = false, .roughness = 0.0, .matt = 0.0}) < 1e-9);
}

TEST_CASE("a rough surface reflects the lamp by its lobe's share, with any sampling") {
    for (const double roughness : {0.15, 0.5, 0.8}) {
        CAPTURE(roughness);
        const Plane plane{.is_lamp_mirrored = true, .roughness = roughness, .matt = 0.0};
        CHECK(std::abs(light_of(plane) / (radiance * plane.lamp_share()) - 1.0) < 0.01);
    }
    const Plane half{.is_lamp_mirrored = true, .roughness = 0.5, .matt = 0.25};
    const Plane matt{.is_lamp_mirrored = true, .roughness = 1.0, .matt = 1.0};
    const double shares = 0.75 * half.lamp_share() + 0.25 * matt.lamp_share();
    CHECK(std::abs(light_of(half) / (radiance * shares) - 1.0) < 0.01);
}

TEST_CASE("white objects are invisible in a uniform white room") {
    PathTracer room = tracer({{"light_intensity", "0"},
                              {"light_height", "500"},
                              {"ambient", "1,1,1"},
                              {"coffee_height", "-900"},
                              {"coffee_color", "1,1,1"},
                              {"carbon_color", "1,1,1"},
                              {"oxygen_color", "1,1,1"},
                              {"nitrogen_color", "1,1,1"},
                              {"atom_roughness", "0.4"},
                              {"bounces", "32"}},
                             {16, 16});
    for (const double light : room.light_after(64))
        CHECK(std::abs(light - 1.0) < 0.004);  // the remaining light after 32 bounces
}

TEST_CASE(
    "the lens is sampled uniformly: the mean distance in its blur disk is 2/3 of the radius") {
    // A small bright object far out of focus becomes a uniform disk: the mean distance from its
    // centre is 2/3 of its radius.
    PathTracer disk = tracer({{"coffee_height", "-900"},
                              {"atom_scale", "0.05"},
                              {"ambient", "0,0,0"},
                              {"light_distance", "0"},
                              {"light_height", "0"},
                              {"light_radius", "0.2"},
                              {"focal_plane", "5"},
                              {"aperture", "1"},
                              {"field_of_view", "20"},
                              {"bounces", "0"}},
                             {32, 32}, 256);
    const std::vector<double> light = disk.light_after(512);
    double sum = 0.0;
    double distances = 0.0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const double here = light[3 * static_cast<std::size_t>(y * 32 + x)];
            sum += here;
            distances += here * std::hypot(x - 15.5, y - 15.5);
        }
    // At distance 10 and focus 5 the lens of radius 1 blurs to 1 Å at the lamp: 32 px / (2 * 10 tan
    // 10°).
    const double radius = 32.0 / (20.0 * std::tan(pi / 18.0));
    CHECK(std::abs(distances / sum / radius - 2.0 / 3.0) < 0.02);
}

TEST_CASE("the error falls faster than random sampling, and is below half of the article's") {
    // Each method is compared with 8192 of its own samples with other random numbers, in the look's
    // own scene.
    const Extent size{32, 32};
    const auto errors_of = [&](const char* pass, const char* as_written,
                               const std::vector<int>& samples) {
        const PathTracer::Settings scene{{"as_written", as_written}};
        PathTracer::Settings other = scene;
        other.emplace_back("seed", "1");
        const auto reference = tracer(other, size, 512).light_after(8192, pass);
        PathTracer drawn = tracer(scene, size, 256);
        std::vector<double> errors;
        for (const int count : samples)
            errors.push_back(root_mean_square_error(drawn.light_after(count, pass), reference));
        return errors;
    };
    const auto ours = errors_of("trace", "false", {256, 512, 1024});
    const double articles = errors_of("article", "true", {256}).front();
    INFO("rms " << ours[0] << " " << ours[1] << " " << ours[2] << ", article " << articles);
    CHECK(ours[1] / ours[2] > 1.35);
    CHECK(ours[0] < 0.45 * articles);
}
