// Texts, scenes and drawings: docs/portable.md, "Paths".
#include "portable_player/error.h"
#include "portable_player/signal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {
using Vector = std::array<double, 3>;

/// A corner of a path: position, and beam current on the way to it.
struct Corner {
    Vector position{};
    double current = 1.0;
};

struct Path {
    std::vector<Corner> corners;
    bool is_smooth = false;
};

/// Paths with a common transform.
struct Item {
    std::vector<Path> paths;
    std::array<double, 2> at{};
    double scale = 1.0;
    Vector turn{};  // degrees
    Vector spin{};  // degrees per second
    double perspective = 0.0;
    double current = 1.0;
    double speed = 1.0;
    double dwell_seconds = 0.0;
};

struct Scene {
    std::vector<Item> items;
    double beam_speed = 1000.0;
    double move_speed = 5000.0;
    double move_current = 0.0;
    double refresh = 60.0;
};

// Scaled, then rotated about x, y and z.
Vector turned(const Item& item, const Vector& position, double seconds) {
    Vector v = position;
    for (double& length : v)
        length *= item.scale;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double angle =
            (item.turn[axis] + item.spin[axis] * seconds) * std::numbers::pi / 180.0;
        double& a = v[(axis + 1) % 3];
        double& b = v[(axis + 2) % 3];
        const double rotated = a * std::cos(angle) - b * std::sin(angle);
        b = a * std::sin(angle) + b * std::cos(angle);
        a = rotated;
    }
    return v;
}

// The position on the screen.
std::array<double, 2> seen(const Item& item, const Vector& position, double seconds) {
    const Vector v = turned(item, position, seconds);
    const double eye = item.perspective;
    const double factor = eye > 0.0 ? eye / std::max(eye - v[2], 0.1 * eye) : 1.0;
    return {item.at[0] + v[0] * factor, item.at[1] + v[1] * factor};
}

/// A corner of a drawing, with its place in space at time 0.
struct Stop {
    const Item* item;
    Vector position;
    Vector place;
};

/// A straight way of the beam, or its wait at a corner.
struct Leg {
    std::size_t from;  // stops
    std::size_t to;
    double seconds;
    double current;
};

/// All legs of one drawing. The scene must outlive it.
class Drawn {
public:
    explicit Drawn(const Scene& scene) : m_scene(scene) {
        for (const Item& item : scene.items)
            for (const Path& path : item.paths)
                add_path(item, path);
        if (m_stops.empty())
            return;
        add_way(m_stops.size() - 1, 0, scene.move_speed, scene.move_current);
        if (scene.refresh > 0.0)
            add({0, 0, 1.0 / scene.refresh - m_seconds, 0.0});
    }

    double seconds() const { return m_seconds; }

    /// Appends the points of a drawing that starts at `start` in from < time <= until.
    void trace(double start, double from, double until, double rate,
               std::vector<BeamPoint>& points) const {
        constexpr double rounding = 1e-9;
        double time = start;
        for (const Leg& leg : m_legs) {
            if (time > until)
                return;
            const bool is_lit = leg.current > 0.0;
            const double steps = is_lit ? std::max(1.0, std::ceil(leg.seconds * rate)) : 1.0;
            const double step = leg.seconds / steps;
            const double charge = is_lit ? leg.current * step * full_charge_rate : 0.0;
            const auto begin = seen_at(leg.from, start);
            const auto end = seen_at(leg.to, start);
            for (double i = 1.0; i <= steps; ++i) {
                const double now = time + i * step;
                if (now > from + rounding && now <= until + rounding)
                    points.push_back({now, std::lerp(begin[0], end[0], i / steps),
                                      std::lerp(begin[1], end[1], i / steps), charge});
            }
            time += leg.seconds;
        }
    }

private:
    void add(const Leg& leg) {
        if (leg.seconds <= 0.0)
            return;
        m_legs.push_back(leg);
        m_seconds += leg.seconds;
    }

    // The time depends on the length in space at time 0.
    void add_way(std::size_t from, std::size_t to, double speed, double current) {
        const Vector& a = m_stops[from].place;
        const Vector& b = m_stops[to].place;
        add({from, to, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / speed, current});
    }

    void add_path(const Item& item, const Path& path) {
        for (std::size_t i = 0; i < path.corners.size(); ++i) {
            const Corner& corner = path.corners[i];
            const std::size_t here = m_stops.size();
            Vector place = turned(item, corner.position, 0.0);
            place[0] += item.at[0];
            place[1] += item.at[1];
            m_stops.push_back({&item, corner.position, place});
            const double current = item.current * corner.current;
            if (i > 0)
                add_way(here - 1, here, m_scene.beam_speed * item.speed, current);
            else if (here > 0)
                add_way(here - 1, here, m_scene.move_speed, m_scene.move_current);
            if (!path.is_smooth || i == 0 || i + 1 == path.corners.size())
                add({here, here, item.dwell_seconds, current});
        }
    }

    std::array<double, 2> seen_at(std::size_t stop, double seconds) const {
        return seen(*m_stops[stop].item, m_stops[stop].position, seconds);
    }

    const Scene& m_scene;
    std::vector<Stop> m_stops;
    std::vector<Leg> m_legs;
    double m_seconds = 0.0;
};

// The first drawing with points after `start`. The last point may be just after its end.
double first_drawing(double start, double length) {
    return std::max(std::floor(start / length) - 1.0, 0.0);
}

class SceneSignal : public Signal {
public:
    SceneSignal(Scene scene, double rate)
        : m_scene(std::move(scene)), m_drawn(m_scene), m_rate(rate) {
        if (m_drawn.seconds() <= 0.0)
            throw Error("has a signal that draws nothing");
    }
    SceneSignal(const SceneSignal&) = delete;
    SceneSignal& operator=(const SceneSignal&) = delete;

    void trace(double start, double end, std::vector<BeamPoint>& points) const override {
        const double length = m_drawn.seconds();
        for (double i = first_drawing(start, length); i * length < end; ++i)
            m_drawn.trace(i * length, start, end, m_rate, points);
    }

private:
    Scene m_scene;
    Drawn m_drawn;
    double m_rate;
};

/// A line of one keyframe and the same line of the next.
struct Morph {
    std::vector<double> from;  // x, y of each point
    std::vector<double> to;
};

/// Keyframes that are held and morph into each other.
class DrawingSignal : public Signal {
public:
    DrawingSignal(const Json& paths, double rate)
        : m_loops(paths.at("loops")),
          m_hold(paths.at("hold_seconds")),
          m_morph(paths.at("morph_seconds")),
          m_is_eased(paths.at("eased")),
          m_spin(paths.at("spin")),
          m_beam_speed(paths.at("beam_speed")),
          m_refresh(paths.at("refresh")),
          m_rate(rate) {
        for (const Json& step : paths.at("steps")) {
            std::vector<Morph>& morphs = m_steps.emplace_back();
            for (const Json& line : step)
                morphs.push_back({line.at("from"), line.at("to")});
        }
        if (m_steps.empty())
            throw Error("has a drawing without steps");
        m_length = longest();
    }

    void trace(double start, double end, std::vector<BeamPoint>& points) const override {
        for (double i = first_drawing(start, m_length); i * m_length < end; ++i) {
            const Scene scene = scene_at(i * m_length);
            Drawn(scene).trace(i * m_length, start, end, m_rate, points);
        }
    }

private:
    Scene scene_at(double seconds) const {
        const double step_seconds = m_hold + m_morph;
        const auto count = static_cast<double>(m_steps.size());
        if (step_seconds <= 0.0)
            return scene_of(m_steps.front(), 0.0);
        const double step = std::floor(seconds / step_seconds);
        if (!m_loops && step >= count)
            return scene_of(m_steps.back(), 1.0);
        const double morphing = seconds - step * step_seconds - m_hold;
        const double even = morphing > 0.0 ? std::min(morphing / m_morph, 1.0) : 0.0;
        const double share = m_is_eased ? even * even * (3.0 - 2.0 * even) : even;
        return scene_of(m_steps[static_cast<std::size_t>(std::fmod(step, count))], share);
    }

    Scene scene_of(const std::vector<Morph>& morphs, double share) const {
        Scene scene{.items = {}, .beam_speed = m_beam_speed, .refresh = m_refresh};
        Item& item = scene.items.emplace_back();
        item.spin[1] = m_spin;
        item.perspective = 3.0;
        for (const Morph& morph : morphs) {
            Path path;
            for (std::size_t i = 0; i + 1 < std::min(morph.from.size(), morph.to.size()); i += 2)
                path.corners.push_back(
                    {{std::lerp(morph.from[i], morph.to[i], share),
                      std::lerp(morph.from[i + 1], morph.to[i + 1], share), 0.0}});
            if (!path.corners.empty())
                item.paths.push_back(std::move(path));
        }
        return scene;
    }

    // The time from one drawing to the next: the longest drawing at the ends of all steps.
    double longest() const {
        double longest = 1.0 / m_refresh;
        for (const auto& step : m_steps)
            for (const double share : {0.0, 1.0}) {
                Scene scene = scene_of(step, share);
                scene.refresh = 0.0;
                longest = std::max(longest, Drawn(scene).seconds());
            }
        return longest;
    }

    std::vector<std::vector<Morph>> m_steps;
    bool m_loops;
    double m_hold;
    double m_morph;
    bool m_is_eased;
    double m_spin;
    double m_beam_speed;
    double m_refresh;
    double m_rate;
    double m_length = 0.0;
};

Path path_of(const Json& json) {
    Path path;
    path.is_smooth = json.at("smooth");
    const std::vector<double> numbers = json.at("points");
    for (std::size_t i = 0; i + 3 < numbers.size(); i += 4)
        path.corners.push_back({{numbers[i], numbers[i + 1], numbers[i + 2]}, numbers[i + 3]});
    return path;
}

Item item_of(const Json& json) {
    Item item;
    for (const Json& path : json.at("paths"))
        item.paths.push_back(path_of(path));
    item.at = json.at("at");
    item.scale = json.at("scale");
    item.turn = json.at("turn");
    item.spin = json.at("spin");
    item.perspective = json.at("perspective");
    item.current = json.at("current");
    item.speed = json.at("speed");
    item.dwell_seconds = json.at("dwell_seconds");
    return item;
}
}  // namespace

std::unique_ptr<Signal> make_scene(const Json& paths, double points_per_second) {
    Scene scene{.items = {},
                .beam_speed = paths.at("beam_speed"),
                .move_speed = paths.at("move_speed"),
                .move_current = paths.at("move_current"),
                .refresh = paths.at("refresh")};
    for (const Json& item : paths.at("items"))
        scene.items.push_back(item_of(item));
    return std::make_unique<SceneSignal>(std::move(scene), points_per_second);
}

std::unique_ptr<Signal> make_drawing(const Json& paths, double points_per_second) {
    return std::make_unique<DrawingSignal>(paths, points_per_second);
}
