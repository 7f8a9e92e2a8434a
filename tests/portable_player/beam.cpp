#include "portable_player/beam.h"

#include <algorithm>

namespace {
// The charge at the start of the segment to `to`. The current at its first point is that of the
// segment before, which took `seconds_before` (0: unknown).
double start_charge(const BeamPoint& from, const BeamPoint& to, double seconds_before) {
    if (from.charge == 0.0 || seconds_before <= 0.0 || to.time <= from.time)
        return to.charge;
    return from.charge * (to.time - from.time) / seconds_before;
}

SegmentVertex segment_between(const BeamPoint& from, const BeamPoint& to, double seconds_before,
                              double end) {
    const auto single = [](double number) { return static_cast<float>(number); };
    return {single(from.x),
            single(from.y),
            single(to.x),
            single(to.y),
            single(start_charge(from, to, seconds_before)),
            single(to.charge),
            single(end - from.time),
            single(std::max(end - to.time, 0.0))};
}
}  // namespace

Beam::Beam(const Signal& signal, const std::array<double, 2>& scale)
    : m_signal(signal), m_scale(scale) {}

void Beam::advance(double start, double end) {
    std::vector<BeamPoint> points;
    m_signal.trace(start, end, points);
    m_points.clear();
    m_segments.clear();
    double seconds_before = 0.0;
    for (BeamPoint& point : points) {
        point.x *= m_scale[0];
        point.y *= m_scale[1];
        m_points.push_back({static_cast<float>(point.x), static_cast<float>(point.y),
                            static_cast<float>(point.charge),
                            static_cast<float>(std::max(end - point.time, 0.0))});
        if (m_last && point.charge != 0.0)
            m_segments.push_back(segment_between(*m_last, point, seconds_before, end));
        seconds_before = m_last ? point.time - m_last->time : 0.0;
        m_last = point;
    }
}

std::array<double, 2> beam_scale(const Description& description, const Size& size) {
    const Json settings = description.signal.value("settings", Json::object());
    const std::string fit = settings.value("fit", "look");
    if (fit == "look")
        return {1.0, 1.0};
    const auto found = std::ranges::find(
        description.parameters, description.passes.front().scope + "fit", &Parameter::name);
    const bool is_round = found != description.parameters.end() && found->is_round_fit;
    const double shorter = std::min(size[0], size[1]);
    const double side = fit == "crop" ? std::max(size[0], size[1]) : shorter;
    std::array<double, 2> scale{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double wanted = fit == "stretch" ? size[axis] : side;
        scale[axis] = wanted / (is_round ? shorter : size[axis]);
    }
    return scale;
}
