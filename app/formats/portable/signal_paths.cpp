#include "formats/portable/signal_paths.h"

#include "signals/drawing/drawn_paths.h"

#include <nlohmann/json.hpp>

#include <cmath>

using Json = nlohmann::ordered_json;

namespace {
// To a millionth of half a screen, which is shorter.
double rounded(double length) {
    return std::round(length * 1e6) / 1e6;
}

Json path_json(const ScenePath& path) {
    Json points = Json::array();
    for (const ScenePoint& point : path.points)
        for (const double number : {point.x, point.y, point.z, point.current})
            points.push_back(rounded(number));
    return {{"points", std::move(points)}, {"smooth", path.is_smooth}};
}

Json item_json(const SceneItem& item) {
    Json json{
        {"paths", Json::array()},  {"at", item.at},       {"scale", item.scale},
        {"turn", item.turn},       {"spin", item.spin},   {"perspective", item.perspective},
        {"current", item.current}, {"speed", item.speed}, {"dwell_seconds", item.dwell_seconds}};
    for (const ScenePath& path : item.paths)
        json["paths"].push_back(path_json(path));
    return json;
}

Json scene_json(const BeamScene& scene) {
    Json json{{"items", Json::array()},
              {"beam_speed", scene.beam_speed},
              {"move_speed", scene.move_speed},
              {"move_current", scene.move_current},
              {"refresh", scene.refresh}};
    for (const SceneItem& item : scene.items)
        json["items"].push_back(item_json(item));
    return json;
}

Json line_json(const std::vector<BeamPosition>& line) {
    Json json = Json::array();
    for (const BeamPosition& position : line)
        for (const double number : position)
            json.push_back(rounded(number));
    return json;
}

Json drawing_json(const DrawnSteps& drawn) {
    Json json{{"steps", Json::array()},
              {"loops", drawn.loops},
              {"hold_seconds", drawn.hold_seconds},
              {"morph_seconds", drawn.morph_seconds},
              {"eased", drawn.is_eased},
              {"spin", drawn.spin},
              {"beam_speed", drawn.beam_speed},
              {"refresh", drawn.refresh}};
    for (const auto& morphs : drawn.steps) {
        Json step = Json::array();
        for (const LineMorph& morph : morphs)
            step.push_back({{"from", line_json(morph.from)}, {"to", line_json(morph.to)}});
        json["steps"].push_back(std::move(step));
    }
    return json;
}
}  // namespace

Result<Json> signal_paths(const Spec& completed, const SignalMedia& media) {
    const auto paths = drawn_paths(completed, media);
    if (!paths)
        return fail(paths.error());
    if (paths->scene)
        return scene_json(*paths->scene);
    return paths->drawing ? drawing_json(*paths->drawing) : Json();
}
