#include "signals/drawing/scene.h"
#include "signals/signal/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {
using Vector = std::array<double, 3>;

/// The rotation of an item at one instant.
class Pose {
public:
    Pose(const SceneItem& item, double seconds) : m_item(item) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double degrees = item.turn[axis] + std::fmod(item.spin[axis] * seconds, 360.0);
            m_cosine[axis] = std::cos(degrees * std::numbers::pi / 180.0);
            m_sine[axis] = std::sin(degrees * std::numbers::pi / 180.0);
        }
    }

    Vector rotated(const ScenePoint& point) const {
        Vector v{point.x * m_item.scale, point.y * m_item.scale, point.z * m_item.scale};
        v = {v[0], v[1] * m_cosine[0] - v[2] * m_sine[0], v[1] * m_sine[0] + v[2] * m_cosine[0]};
        v = {v[0] * m_cosine[1] + v[2] * m_sine[1], v[1], v[2] * m_cosine[1] - v[0] * m_sine[1]};
        return {v[0] * m_cosine[2] - v[1] * m_sine[2], v[0] * m_sine[2] + v[1] * m_cosine[2], v[2]};
    }

    /// On the screen. The distance to the eye is at least a tenth of `perspective`.
    std::array<double, 2> seen(const ScenePoint& point) const {
        const Vector v = rotated(point);
        const double eye = m_item.perspective;
        const double nearer = eye > 0.0 ? eye / std::max(eye - v[2], 0.1 * eye) : 1.0;
        return {m_item.at[0] + v[0] * nearer, m_item.at[1] + v[1] * nearer};
    }

    /// In space, for lengths.
    Vector placed(const ScenePoint& point) const {
        const Vector v = rotated(point);
        return {v[0] + m_item.at[0], v[1] + m_item.at[1], v[2]};
    }

private:
    const SceneItem& m_item;
    Vector m_cosine{};
    Vector m_sine{};
};

double distance_between(const Vector& a, const Vector& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A corner and its item.
struct Corner {
    std::size_t item = 0;
    ScenePoint point;
};

/// The beam's path to a corner, or its dwell there.
struct Leg {
    std::size_t from = 0;  // corners
    std::size_t to = 0;
    double begin = 0.0;  // s after the drawing's start
    double seconds = 0.0;
    double current = 0.0;  // 0: blanked
};

/// The legs of a drawing; the same for each drawing.
class Timetable {
public:
    explicit Timetable(const BeamScene& scene) : m_scene(scene) {
        std::vector<Pose> poses;
        for (const SceneItem& item : scene.items)
            poses.emplace_back(item, 0.0);
        for (std::size_t i = 0; i < scene.items.size(); ++i)
            for (const ScenePath& path : scene.items[i].paths)
                add_path(i, path, poses[i]);
        if (m_corners.empty())
            return;
        add_move(m_corners.size() - 1, 0);
        if (scene.refresh > 0.0)
            add({0, 0, m_seconds, 1.0 / scene.refresh - m_seconds, 0.0});
    }

    const std::vector<Corner>& corners() const { return m_corners; }
    const std::vector<Leg>& legs() const { return m_legs; }
    double seconds() const { return m_seconds; }

private:
    void add(const Leg& leg) {
        if (leg.seconds <= 0.0)
            return;
        m_legs.push_back(leg);
        m_seconds += leg.seconds;
    }

    void add_move(std::size_t from, std::size_t to) {
        const double way = distance_between(m_places[from], m_places[to]);
        add({from, to, m_seconds, way / m_scene.move_speed, m_scene.move_current});
    }

    void add_path(std::size_t index, const ScenePath& path, const Pose& pose) {
        const SceneItem& item = m_scene.items[index];
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            const std::size_t here = m_corners.size();
            m_corners.push_back({index, path.points[i]});
            m_places.push_back(pose.placed(path.points[i]));
            const double current = item.current * path.points[i].current;
            if (i > 0)
                add({here - 1, here, m_seconds,
                     distance_between(m_places[here - 1], m_places[here]) /
                         (m_scene.beam_speed * item.speed),
                     current});
            else if (here > 0)
                add_move(here - 1, here);
            const bool is_corner = !path.is_smooth || i == 0 || i + 1 == path.points.size();
            add({here, here, m_seconds, is_corner ? item.dwell_seconds : 0.0, current});
        }
    }

    const BeamScene& m_scene;
    std::vector<Corner> m_corners;
    std::vector<Vector> m_places;  // of the corners at time 0
    std::vector<Leg> m_legs;
    double m_seconds = 0.0;
};

/// Point rate and time span of a trace.
struct Tracing {
    double rate = 0.0;
    TimeSpan span;
};

constexpr double span_slack = 1e-9;  // s: tolerance for span ends computed in two ways

/// One drawing of a scene, in the state at its start.
class DrawnOnce {
public:
    DrawnOnce(const BeamScene& scene, const Timetable& table, double start)
        : m_table(table), m_start(start) {
        for (const SceneItem& item : scene.items)
            m_poses.emplace_back(item, start);
    }

    void trace(const Tracing& tracing, Beam& beam) const {
        const auto& legs = m_table.legs();
        auto leg = std::upper_bound(legs.begin(), legs.end(), tracing.span.start - m_start,
                                    [](double time, const Leg& other) {
                                        return time < other.begin + other.seconds + span_slack;
                                    });
        for (; leg != legs.end() && m_start + leg->begin <= tracing.span.end; ++leg)
            trace_leg(*leg, tracing, beam);
    }

private:
    void trace_leg(const Leg& leg, const Tracing& tracing, Beam& beam) const {
        const double start = m_start + leg.begin;
        const TimeSpan& span = tracing.span;
        const auto from = position_of(leg.from);
        const auto to = position_of(leg.to);
        const bool is_lit = leg.current > 0.0;
        const double steps = is_lit ? std::max(1.0, std::ceil(leg.seconds * tracing.rate)) : 1.0;
        const double step = leg.seconds / steps;
        const double charge = is_lit ? leg.current * step * charge_of_point(1.0) : 0.0;
        const double first = std::floor((span.start - start) / step);
        for (double i = std::clamp(first, 1.0, steps); i <= steps; ++i) {
            const double time = start + i * step;
            if (time > span.end + span_slack)
                return;
            if (time <= span.start + span_slack)
                continue;
            const double share = i / steps;
            beam.push_back({static_cast<float>(std::lerp(from[0], to[0], share)),
                            static_cast<float>(std::lerp(from[1], to[1], share)),
                            static_cast<float>(charge),
                            static_cast<float>(std::max(span.end - time, 0.0))});
        }
    }

    std::array<double, 2> position_of(std::size_t corner) const {
        const Corner& at = m_table.corners()[corner];
        return m_poses[at.item].seen(at.point);
    }

    const Timetable& m_table;
    double m_start;
    std::vector<Pose> m_poses;
};

// Of drawings that start at this interval. Only a fixed rate repeats together with other parts.
Repetition repetition_of_drawings(double seconds, double refresh) {
    constexpr double rounding = 1e-9;
    Repetition repetition;
    if (refresh > 0.0 && seconds <= 1.0 / refresh + rounding)
        repetition.add(refresh);
    else
        repetition.error = fmt::format(
            "one drawing takes {:.4g} s, so it has no fixed rate. Raise the beam speed until it "
            "fits the refresh rate.",
            seconds);
    return repetition;
}

// The first drawing with points in the span; each is `length` long.
std::int64_t first_drawing(const TimeSpan& span, double length) {
    const auto drawing = static_cast<std::int64_t>(std::floor(std::max(span.start, 0.0) / length));
    return std::max<std::int64_t>(drawing - 1, 0);  // its last point may be just after its end
}

class SceneSignal : public Signal {
public:
    SceneSignal(std::shared_ptr<const BeamScene> scene, double rate)
        : m_scene(std::move(scene)), m_table(*m_scene), m_rate(rate) {}

    const Timetable& table() const { return m_table; }

    void trace(const TimeSpan& span, Beam& beam) const override {
        const double length = m_table.seconds();
        for (auto drawing = first_drawing(span, length);
             static_cast<double>(drawing) * length < span.end; ++drawing)
            DrawnOnce(*m_scene, m_table, static_cast<double>(drawing) * length)
                .trace({m_rate, span}, beam);
    }

    Repetition repetition() const override {
        Repetition repetition = repetition_of_drawings(m_table.seconds(), m_scene->refresh);
        for (const SceneItem& item : m_scene->items)
            for (const double spin : item.spin)
                repetition.add(spin / 360.0);
        return repetition;
    }

private:
    std::shared_ptr<const BeamScene> m_scene;  // shared with other players of the same file
    Timetable m_table;
    double m_rate;
};

class ChangingSceneSignal : public Signal {
public:
    ChangingSceneSignal(ChangingScene scene, double rate)
        : m_scene(std::move(scene)), m_rate(rate) {}

    void trace(const TimeSpan& span, Beam& beam) const override {
        const double length = m_scene.seconds;
        for (auto drawing = first_drawing(span, length);
             static_cast<double>(drawing) * length < span.end; ++drawing) {
            const double start = static_cast<double>(drawing) * length;
            const BeamScene scene = m_scene.at(start);
            const Timetable table(scene);
            DrawnOnce(scene, table, start).trace({m_rate, span}, beam);
        }
    }

    Repetition repetition() const override {
        Repetition repetition = repetition_of_drawings(m_scene.seconds, m_scene.at(0.0).refresh);
        repetition.add(m_scene.repetition);
        return repetition;
    }

private:
    ChangingScene m_scene;
    double m_rate;
};
}  // namespace

std::size_t point_count(const BeamScene& scene) {
    std::size_t count = 0;
    for (const SceneItem& item : scene.items)
        for (const ScenePath& path : item.paths)
            count += path.points.size();
    return count;
}

Result<std::unique_ptr<Signal>> make_scene_signal(std::shared_ptr<const BeamScene> scene,
                                                  double rate) {
    if (point_count(*scene) > max_scene_points)
        return fail({{},
                     0,
                     fmt::format("too many points ({}); the limit is {}", point_count(*scene),
                                 max_scene_points)});
    auto signal = std::make_unique<SceneSignal>(std::move(scene), rate);
    const auto& legs = signal->table().legs();
    const bool draws =
        std::any_of(legs.begin(), legs.end(), [](const Leg& leg) { return leg.current > 0.0; });
    if (!draws || signal->table().seconds() < 1e-6)
        return fail({{}, 0, "nothing to draw"});
    return signal;
}

double drawing_seconds(BeamScene scene) {
    scene.refresh = 0.0;
    return Timetable(scene).seconds();
}

std::unique_ptr<Signal> make_changing_scene_signal(ChangingScene scene, double rate) {
    return std::make_unique<ChangingSceneSignal>(std::move(scene), rate);
}
