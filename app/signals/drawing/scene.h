#pragma once

#include "base/diagnostic.h"
#include "signals/signal/signal.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

/// A corner of a path: half screens from its item's middle, y up, z towards the eye.
struct ScenePoint {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double current = 1.0;  // on the way to it, 1 is full

    bool operator==(const ScenePoint&) const = default;
};

/// What the beam draws without leaving off.
struct ScenePath {
    std::vector<ScenePoint> points;
    bool is_smooth = false;  // has no corners on which to dwell, but at its ends

    bool operator==(const ScenePath&) const = default;
};

/// Paths that are placed and turned together: scaled, turned about x, then y, then z, moved.
struct SceneItem {
    std::vector<ScenePath> paths;
    std::array<double, 2> at{};  // half screens
    double scale = 1.0;
    std::array<double, 3> turn{};  // degrees at time 0, counter-clockwise
    std::array<double, 3> spin{};  // degrees/s
    double perspective = 0.0;      // half screens from the eye to the item's middle; 0: from afar
    double current = 1.0;          // times that of the points
    double speed = 1.0;            // times the scene's beam speed
    double dwell_seconds = 0.0;    // at each corner

    bool operator==(const SceneItem&) const = default;
};

/// What a beam draws over and over: items in order, and how it moves on and between them.
struct BeamScene {
    std::vector<SceneItem> items;
    double beam_speed = 1000.0;  // half screens/s
    double move_speed = 5000.0;  // between paths
    double move_current = 0.0;   // 0: blanked
    double refresh = 60.0;  // at most so many drawings a second; 0: as many as there is time for

    bool operator==(const BeamScene&) const = default;
};

/// So many points hold any scene that a beam could draw while someone looks.
constexpr std::size_t most_scene_points = 400000;

std::size_t point_count(const BeamScene& scene);

/// The scene as a signal, at `rate` points a second or more: each straight way is cut evenly, and
/// its ends are always points. Things turn from one drawing to the next; how long each way takes is
/// settled by its length in space, so that every drawing takes equally long. Refuses a scene that
/// draws nothing.
Result<std::unique_ptr<Signal>> make_scene_signal(std::shared_ptr<const BeamScene> scene,
                                                  double rate);

/// A scene that is another one each time the beam begins to draw it.
struct ChangingScene {
    std::function<BeamScene(double seconds)> at;  // as it is drawn from then on
    double seconds = 1.0 / 60.0;  // from one beginning to the next: no drawing takes longer
};

/// As make_scene_signal; there may be nothing to draw, for a time or for ever.
std::unique_ptr<Signal> make_changing_scene_signal(ChangingScene scene, double rate);

/// How long the beam takes to draw it and to come back.
double drawing_seconds(BeamScene scene);
