#pragma once

#include "base/diagnostic.h"
#include "model/tuning/repetition.h"
#include "signals/signal/signal.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

/// A corner of a path: half screens from its item's centre, y up, z towards the eye.
struct ScenePoint {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double current = 1.0;  // on the way to it; 1 is full

    bool operator==(const ScenePoint&) const = default;
};

/// A line that the beam draws without a gap.
struct ScenePath {
    std::vector<ScenePoint> points;
    bool is_smooth = false;  // dwells at its ends only

    bool operator==(const ScenePath&) const = default;
};

/// Paths with a common transform: scale, rotation about x, then y, then z, translation.
struct SceneItem {
    std::vector<ScenePath> paths;
    std::array<double, 2> at{};  // half screens
    double scale = 1.0;
    std::array<double, 3> turn{};  // degrees at time 0, counter-clockwise
    std::array<double, 3> spin{};  // degrees/s
    double perspective = 0.0;      // half screens from the eye to the item's centre; 0:
                                   // orthographic
    double current = 1.0;          // factor of the points' current
    double speed = 1.0;            // factor of the scene's beam speed
    double dwell_seconds = 0.0;    // at each corner

    bool operator==(const SceneItem&) const = default;
};

/// A scene that the beam draws repeatedly: items in order, and the beam's speeds.
struct BeamScene {
    std::vector<SceneItem> items;
    double beam_speed = 1000.0;  // half screens/s
    double move_speed = 5000.0;  // between paths
    double move_current = 0.0;   // 0: blanked
    double refresh = 60.0;       // maximum drawings per second; 0: no maximum

    bool operator==(const BeamScene&) const = default;
};

/// More points than a beam could draw at a visible refresh rate.
constexpr std::size_t max_scene_points = 400000;

std::size_t point_count(const BeamScene& scene);

/// The scene as a signal with at least `rate` points per second. Each straight segment is divided
/// evenly, and its ends are always points. Rotation changes between drawings only. The duration of
/// a segment depends on its length in space, so every drawing takes the same time. Error: a scene
/// that draws nothing.
Result<std::unique_ptr<Signal>> make_scene_signal(std::shared_ptr<const BeamScene> scene,
                                                  double rate);

/// A scene that changes at the start of each drawing.
struct ChangingScene {
    std::function<BeamScene(double seconds)> at;  // the scene drawn from that time on
    double seconds = 1.0 / 60.0;                  // between starts; no drawing takes longer
    Repetition repetition = {};                   // of `at`
};

/// Like make_scene_signal(), but the scene may be empty.
std::unique_ptr<Signal> make_changing_scene_signal(ChangingScene scene, double rate);

/// Duration of a drawing, including the return to its start.
double drawing_seconds(BeamScene scene);
