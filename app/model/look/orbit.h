#pragma once

#include "model/look/look.h"

#include <array>
#include <functional>
#include <vector>

/// Rotation by the mouse: of the object, and of the camera around it.
struct Orbit {
    std::array<double, 3> turn_degrees{};  // about x, then y, then z
    double azimuth_degrees = 0.0;          // of the camera, to the right
    double elevation_degrees = 0.0;        // of the camera, upwards; -90 .. 90
    double distance = 1.0;                 // relative to the look's own distance

    bool operator==(const Orbit&) const = default;
};

/// A column-major matrix for a mat4 uniform.
using Matrix = std::array<double, 16>;

/// `u_view`: rotates points of the object.
Matrix view_matrix(const Orbit& orbit);
/// `u_camera`: maps positions and directions of the default camera, relative to its target, to the
/// moved camera. Lengths scale with the distance.
Matrix camera_matrix(const Orbit& orbit);

/// A drag over the picture, in degrees: the object follows the pointer at any orientation of camera
/// and object.
Orbit with_object_turned(Orbit orbit, double right, double up);
/// The scene follows the pointer, so the camera moves in the opposite direction.
Orbit with_camera_moved(Orbit orbit, double right, double up);
/// `factor` below 1 moves closer.
Orbit with_distance_scaled(Orbit orbit, double factor);

/// The parameters of an orbit, for the passes that declare `u_view` and `u_camera`; nothing for a
/// matrix that no pass declares. Presets, undo and `--set` treat them like other parameters.
std::vector<Parameter> orbit_parameters(const std::vector<int>& view_passes,
                                        const std::vector<int>& camera_passes);
/// The orbit of a pass.
Orbit orbit_of(const Look& look, const Values& values, int pass);
/// Applies `change` to each of the look's orbits (a stack may have several) and sets its
/// parameters.
Values with_orbits_changed(const Look& look, Values values,
                           const std::function<Orbit(const Orbit&)>& change);
