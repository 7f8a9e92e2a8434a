#pragma once

#include "model/look/look.h"

#include <array>
#include <functional>
#include <vector>

/// How the mouse has turned what a look shows: the object by itself, and the camera around it.
struct Orbit {
    std::array<double, 3> turn_degrees{};  // about x, then y, then z
    double azimuth_degrees = 0.0;          // of the camera, to the right
    double elevation_degrees = 0.0;        // of the camera, upwards; -90 .. 90
    double distance = 1.0;                 // times the look's own

    bool operator==(const Orbit&) const = default;
};

/// A matrix by columns, as a mat4 uniform takes it.
using Matrix = std::array<double, 16>;

/// `u_view`: turns points of the object.
Matrix view_matrix(const Orbit& orbit);
/// `u_camera`: takes places and directions of the resting camera, seen from what it looks at, to
/// where it has moved. Its lengths grow with the distance.
Matrix camera_matrix(const Orbit& orbit);

/// A drag over the picture, in degrees: the object follows the hand, however camera and object
/// stand.
Orbit with_object_turned(Orbit orbit, double right, double up);
/// The scene follows the hand: the camera goes the other way.
Orbit with_camera_moved(Orbit orbit, double right, double up);
/// `factor` below 1 is nearer.
Orbit with_distance_scaled(Orbit orbit, double factor);

/// The parameters of an orbit, for the passes that declare `u_view` and `u_camera`; none for a
/// matrix that no pass declares. So an orbit is in presets, undo and `--set` as all else is.
std::vector<Parameter> orbit_parameters(const std::vector<int>& view_passes,
                                        const std::vector<int>& camera_passes);
/// The orbit that a pass is given.
Orbit orbit_of(const Look& look, const Values& values, int pass);
/// Sets the parameters of each of the look's orbits (in a stack there may be several) to what
/// `change` makes of it.
Values with_orbits_changed(const Look& look, Values values,
                           const std::function<Orbit(const Orbit&)>& change);
