#include "model/look/orbit.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace {
constexpr double nearest = 0.1;
constexpr double farthest = 10.0;
const glm::dvec3 to_the_right(1.0, 0.0, 0.0);
const glm::dvec3 upwards(0.0, 1.0, 0.0);

Matrix matrix_of(const glm::dmat4& matrix) {
    Matrix numbers;
    std::copy_n(glm::value_ptr(matrix), numbers.size(), numbers.begin());
    return numbers;
}

glm::dquat turn_of(const Orbit& orbit) {
    return {glm::radians(
        glm::dvec3(orbit.turn_degrees[0], orbit.turn_degrees[1], orbit.turn_degrees[2]))};
}

glm::dquat camera_turn(const Orbit& orbit) {
    return glm::angleAxis(glm::radians(orbit.azimuth_degrees), upwards) *
           glm::angleAxis(-glm::radians(orbit.elevation_degrees), to_the_right);
}

// Short in a preset, and finer than a mouse drag.
double rounded_degrees(double degrees) {
    return std::round(degrees * 100.0) / 100.0;
}

double within_a_turn(double degrees) {
    return std::remainder(degrees, 360.0);
}
}  // namespace

Matrix view_matrix(const Orbit& orbit) {
    return matrix_of(glm::mat4_cast(turn_of(orbit)));
}

Matrix camera_matrix(const Orbit& orbit) {
    return matrix_of(glm::scale(glm::mat4_cast(camera_turn(orbit)), glm::dvec3(orbit.distance)));
}

Orbit with_object_turned(Orbit orbit, double right, double up) {
    const glm::dquat camera = camera_turn(orbit);
    const glm::dquat rotated = glm::angleAxis(glm::radians(right), camera * upwards) *
                               glm::angleAxis(-glm::radians(up), camera * to_the_right) *
                               turn_of(orbit);
    const glm::dvec3 degrees = glm::degrees(glm::eulerAngles(rotated));
    orbit.turn_degrees = {rounded_degrees(degrees.x), rounded_degrees(degrees.y),
                          rounded_degrees(degrees.z)};
    return orbit;
}

Orbit with_camera_moved(Orbit orbit, double right, double up) {
    orbit.azimuth_degrees = rounded_degrees(within_a_turn(orbit.azimuth_degrees - right));
    orbit.elevation_degrees =
        rounded_degrees(std::clamp(orbit.elevation_degrees - up, -90.0, 90.0));
    return orbit;
}

Orbit with_distance_scaled(Orbit orbit, double factor) {
    const double distance = std::clamp(orbit.distance * factor, nearest, farthest);
    orbit.distance = std::round(distance * 1000.0) / 1000.0;
    return orbit;
}

namespace {
Parameter part_of_orbit(OrbitPart part, std::string name, std::string label, std::string help) {
    Parameter parameter;
    parameter.orbit = part;
    parameter.name = std::move(name);
    parameter.label = std::move(label);
    parameter.help = std::move(help);
    parameter.group = "View";
    parameter.unit = "°";
    parameter.initial = 0.0;
    parameter.range = {-180.0, 180.0, 0.0};
    return parameter;
}

void give_to_passes(std::vector<Parameter>& parameters, std::size_t first,
                    const std::vector<int>& passes, const char* uniform) {
    for (std::size_t i = first; i < parameters.size(); ++i)
        for (const int pass : passes)
            parameters[i].bindings.push_back({pass, uniform});
}
}  // namespace

std::vector<Parameter> orbit_parameters(const std::vector<int>& view_passes,
                                        const std::vector<int>& camera_passes) {
    std::vector<Parameter> parameters;
    if (!view_passes.empty()) {
        Parameter turn = part_of_orbit(
            OrbitPart::turn, "orbit_turn", "Object rotation",
            "Rotation about the x, y and z axes, in this order. Drag the picture to change it.");
        turn.type.rows = 3;
        turn.initial = std::vector<double>{0.0, 0.0, 0.0};
        parameters.push_back(std::move(turn));
        give_to_passes(parameters, 0, view_passes, "u_view");
    }
    if (camera_passes.empty())
        return parameters;
    const std::size_t first = parameters.size();
    parameters.push_back(
        part_of_orbit(OrbitPart::azimuth, "orbit_azimuth", "Camera azimuth",
                      "Horizontal angle, positive to the right. Drag the picture with the right "
                      "mouse button to change it."));
    parameters.push_back(part_of_orbit(OrbitPart::elevation, "orbit_elevation", "Camera elevation",
                                       "Vertical angle. At 90° the camera looks straight down."));
    parameters.back().range = {-90.0, 90.0, 0.0};
    parameters.back().limit = Limit{-90.0, 90.0};
    parameters.push_back(part_of_orbit(
        OrbitPart::distance, "orbit_distance", "Camera distance",
        "Relative to the look's own distance. Hold Ctrl and scroll over the picture to "
        "change it."));
    Parameter& distance = parameters.back();
    distance.unit = "×";
    distance.initial = 1.0;
    distance.range = {0.3, 3.0, 0.0};
    distance.limit = Limit{nearest, farthest};
    distance.scale = Scale::logarithmic;
    give_to_passes(parameters, first, camera_passes, "u_camera");
    return parameters;
}

namespace {
void take(Orbit& orbit, const Parameter& parameter, const Value& value) {
    switch (parameter.orbit) {
        case OrbitPart::turn:
            for (std::size_t i = 0; i < std::min<std::size_t>(value.numbers.size(), 3); ++i)
                orbit.turn_degrees[i] = value.numbers[i];
            break;
        case OrbitPart::azimuth:
            orbit.azimuth_degrees = value.number();
            break;
        case OrbitPart::elevation:
            orbit.elevation_degrees = value.number();
            break;
        case OrbitPart::distance:
            orbit.distance = value.number();
            break;
        case OrbitPart::none:
            break;
    }
}

Value value_from(const Orbit& orbit, OrbitPart part) {
    switch (part) {
        case OrbitPart::turn:
            return std::vector<double>(orbit.turn_degrees.begin(), orbit.turn_degrees.end());
        case OrbitPart::azimuth:
            return orbit.azimuth_degrees;
        case OrbitPart::elevation:
            return orbit.elevation_degrees;
        case OrbitPart::distance:
        case OrbitPart::none:
            break;
    }
    return orbit.distance;
}

// The common prefix of an orbit's parameters in a stack: "caffeine/" of "caffeine/orbit_turn".
std::string owner_of(const Parameter& parameter) {
    return parameter.name.substr(0, parameter.name.rfind('/') + 1);
}
}  // namespace

Orbit orbit_of(const Look& look, const Values& values, int pass) {
    Orbit orbit;
    for (const Parameter& parameter : look.parameters)
        if (parameter.orbit != OrbitPart::none &&
            std::ranges::find(parameter.bindings, pass, &Binding::pass) != parameter.bindings.end())
            take(orbit, parameter, clamped(parameter, value_of(parameter, values)));
    return orbit;
}

Values with_orbits_changed(const Look& look, Values values,
                           const std::function<Orbit(const Orbit&)>& change) {
    std::set<std::string> owners;
    for (const Parameter& parameter : look.parameters)
        if (parameter.orbit != OrbitPart::none)
            owners.insert(owner_of(parameter));
    for (const std::string& owner : owners) {
        Orbit orbit;
        std::vector<const Parameter*> parts;
        for (const Parameter& parameter : look.parameters)
            if (parameter.orbit != OrbitPart::none && owner_of(parameter) == owner)
                parts.push_back(&parameter);
        for (const Parameter* part : parts)
            take(orbit, *part, value_of(*part, values));
        orbit = change(orbit);
        for (const Parameter* part : parts)
            values[part->name] = value_from(orbit, part->orbit);
    }
    return values;
}
