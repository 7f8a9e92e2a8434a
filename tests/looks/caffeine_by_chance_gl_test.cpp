// Caffeine compared with the simplest path tracer, which hits the lamp only by chance. Importance
// sampling, weights and path termination must give the same light.
#include "looks/path_tracer.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <array>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>

namespace {
constexpr Extent size{8, 6};
constexpr int max_bounces = 3;

struct Vector {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    Vector operator+(const Vector& o) const { return {x + o.x, y + o.y, z + o.z}; }
    Vector operator-(const Vector& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Vector operator*(double factor) const { return {x * factor, y * factor, z * factor}; }
};

double dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector unit(const Vector& a) {
    return a * (1.0 / std::sqrt(dot(a, a)));
}

struct Ball {
    Vector center;
    double radius = 0.0;
};

struct Material {
    double gray = 0.0;
    double roughness = 0.0;
    double matt = 0.0;
};

struct Ray {
    Vector origin;
    Vector direction;
};

/// Only Caffeine's two oxygen atoms over the coffee. The lamp is visible and out of focus, with
/// half of its edge hidden.
struct Scene {
    std::array<Ball, 2> oxygens{
        {{{-0.4926797, -2.8180554, -1.2094732}, 1.5}, {{-2.2301338, 0.7988624, 1.0899730}, 1.5}}};
    Material oxygen{0.8, 0.5, 0.4};
    double coffee_height = -3.0;
    Material coffee{0.6, 0.3, 0.5};
    Ball lamp{{-1.0, 1.5, -3.0}, 1.8};
    double lamp_light = 6.0 * 1.5;
    double lamp_shown = 6.0 * 0.25;
    double ambient = 0.2;
    Vector eye{0.0, 0.5, 9.0};
    Vector target{0.0, -0.5, 0.0};
    double focal_plane = 4.0;
    double aperture = 2.0;

    PathTracer::Settings settings(int bounces) const {
        return {{"hydrogen_radius", "0"},
                {"carbon_radius", "0"},
                {"nitrogen_radius", "0"},
                {"oxygen_radius", "1.5"},
                {"atom_scale", "1"},
                {"oxygen_color", "0.8,0.8,0.8"},
                {"atom_roughness", "0.5"},
                {"atom_matt", "0.4"},
                {"coffee_height", "-3"},
                {"coffee_color", "0.6,0.6,0.6"},
                {"coffee_roughness", "0.3"},
                {"coffee_matt", "0.5"},
                {"light_angle", "4.3906384"},
                {"light_distance", "3.1622777"},
                {"light_height", "1.5"},
                {"light_radius", "1.8"},
                {"light_color", "1,1,1"},
                {"light_intensity", "1.5"},
                {"light_shown", "0.25"},
                {"ambient", "0.2,0.2,0.2"},
                {"camera_place", "0,0.5,9"},
                {"camera_target", "0,-0.5,0"},
                {"focal_plane", "4"},
                {"aperture", "2"},
                {"bounces", std::to_string(bounces)}};
    }
};

class Chance {
public:
    double number() { return m_numbers(m_source); }
    Vector in_ball() {
        for (;;) {
            const Vector place{2 * number() - 1, 2 * number() - 1, 2 * number() - 1};
            if (dot(place, place) < 1.0 && dot(place, place) > 1e-12)
                return place;
        }
    }
    Vector on_disk() {
        for (;;) {
            const Vector place{2 * number() - 1, 2 * number() - 1, 0};
            if (dot(place, place) < 1.0)
                return place;
        }
    }

private:
    std::mt19937_64 m_source{1};
    std::uniform_real_distribution<double> m_numbers{0.0, 1.0};
};

std::optional<double> distance_to(const Ball& ball, const Ray& ray) {
    const Vector from = ray.origin - ball.center;
    const double back = dot(from, ray.direction);
    const double inside = back * back - dot(from, from) + ball.radius * ball.radius;
    if (inside < 0.0 || -back - std::sqrt(inside) <= 1e-9)
        return {};
    return -back - std::sqrt(inside);
}

Ray camera_ray(const Scene& scene, double x, double y, Chance& chance) {
    const Vector forward = unit(scene.target - scene.eye);
    const Vector right = unit(cross(forward, {0, 1, 0}));
    const Vector up = cross(right, forward);
    const double slope = std::tan(std::numbers::pi / 6.0);
    const double across = (2.0 * (x + chance.number()) - size.width) / size.height * slope;
    const double upwards = (2.0 * (y + chance.number()) - size.height) / size.height * slope;
    const double depth = dot(scene.target - scene.eye, forward) - scene.focal_plane;
    const Vector focus = scene.eye + (forward + right * across + up * upwards) * depth;
    const Vector lens = chance.on_disk() * scene.aperture;
    const Vector origin = scene.eye + right * lens.x + up * lens.y;
    return {origin, unit(focus - origin)};
}

Ray bounced(const Ray& ray, double away, const Vector& normal, const Material& material,
            Chance& chance) {
    const Vector place = ray.origin + ray.direction * away;
    const Vector even = normal + unit(chance.in_ball());
    const Vector mirrored = ray.direction - normal * (2.0 * dot(ray.direction, normal));
    const bool is_matt = chance.number() < material.matt;
    const double share = is_matt ? 1.0 : material.roughness;
    return {place + normal * 1e-9, unit(mirrored * (1.0 - share) + even * share)};
}

/// The light of one path, for each number of bounces.
std::array<double, max_bounces + 1> light_of(const Scene& scene, Ray ray, Chance& chance) {
    std::array<double, max_bounces + 1> light{};
    const auto add = [&](int rays, double brightness) {
        for (int bounces = std::max(0, rays - 1); bounces <= max_bounces; ++bounces)
            light[static_cast<std::size_t>(bounces)] += brightness;
    };
    double carried = 1.0;
    for (int rays = 0; rays <= max_bounces + 1; ++rays) {
        double away = 1e30;
        const Ball* ball = nullptr;
        for (const Ball* other : {&scene.oxygens[0], &scene.oxygens[1], &scene.lamp})
            if (const auto met = distance_to(*other, ray); met && *met < away) {
                away = *met;
                ball = other;
            }
        const double coffee = (scene.coffee_height - ray.origin.y) / ray.direction.y;
        const bool is_coffee = coffee > 0.0 && coffee < away;
        if (!is_coffee && (!ball || ball == &scene.lamp)) {
            const double lamp = rays == 0 ? scene.lamp_shown : scene.lamp_light;
            add(rays, carried * (ball ? lamp : scene.ambient));
            break;
        }
        away = is_coffee ? coffee : away;
        const Material& material = is_coffee ? scene.coffee : scene.oxygen;
        const Vector normal =
            is_coffee ? Vector{0, 1, 0} : unit(ray.origin + ray.direction * away - ball->center);
        carried *= material.gray;
        ray = bounced(ray, away, normal, material, chance);
    }
    return light;
}

struct Estimate {
    double mean = 0.0;
    double error = 0.0;  // one standard deviation of the mean
};
/// For each number of bounces and each pixel, top row first.
using Estimates = std::array<std::vector<Estimate>, max_bounces + 1>;

Estimates estimates_by_chance(const Scene& scene, int paths) {
    Chance chance;
    Estimates estimates;
    for (int pixel = 0; pixel < size.width * size.height; ++pixel) {
        std::array<double, max_bounces + 1> sums{};
        std::array<double, max_bounces + 1> squares{};
        for (int path = 0; path < paths; ++path) {
            const int y = size.height - 1 - pixel / size.width;
            const auto light =
                light_of(scene, camera_ray(scene, pixel % size.width, y, chance), chance);
            for (std::size_t i = 0; i < light.size(); ++i) {
                sums[i] += light[i];
                squares[i] += light[i] * light[i];
            }
        }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const double mean = sums[i] / paths;
            estimates[i].push_back({mean, std::sqrt((squares[i] / paths - mean * mean) / paths)});
        }
    }
    return estimates;
}
}  // namespace

TEST_CASE("every pixel matches the brute-force path tracer, for any number of bounces") {
    const Scene scene;
    const Estimates right = estimates_by_chance(scene, 20000);
    for (const int bounces : {0, 1, max_bounces}) {
        CAPTURE(bounces);
        auto tracer = PathTracer::create(scene.settings(bounces), size, 256);
        REQUIRE_MESSAGE(tracer.has_value(), problems_of(tracer));
        const std::vector<double> light = tracer->light_after(1024);
        double sum = 0.0;
        double right_sum = 0.0;
        double deviations = 0.0;
        const auto& pixels = right[static_cast<std::size_t>(bounces)];
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            sum += light[3 * i];
            right_sum += pixels[i].mean;
            const double error = std::max(pixels[i].error, 1e-3);  // at least our own error
            deviations += std::pow((light[3 * i] - pixels[i].mean) / error, 2.0);
        }
        INFO("light " << sum << " against " << right_sum);
        CHECK(std::abs(sum / right_sum - 1.0) < 0.005);
        CHECK(deviations / static_cast<double>(pixels.size()) < 1.6);  // expected value 1
    }
}
