#include "lab/beam_place.h"

#include "model/stack.h"

#include <algorithm>

namespace {
const Parameter* parameter_of_screen(const Look& look, const std::string& name) {
    const std::string scope = look.stack.size() > 1 ? scope_of(look.stack, 0) : std::string();
    return find_parameter(look, scope + name);
}

double number_of(const Look& look, const Values& values, const std::string& name, double fallback) {
    const Parameter* parameter = parameter_of_screen(look, name);
    return parameter ? value_of(*parameter, values).numbers[0] : fallback;
}

bool keeps_circles_round(const Look& look, const Values& values) {
    const Parameter* fit = parameter_of_screen(look, "fit");
    if (!fit)
        return false;
    const double chosen = value_of(*fit, values).numbers[0];
    return std::any_of(fit->items.begin(), fit->items.end(), [chosen](const Item& item) {
        return item.value == chosen && item.label == "Keep circles round";
    });
}

// How far the glass pushes a place out along one axis, from how far it is along the other.
double pushed_out(double across, double curvature) {
    return 1.0 + across * across * curvature * 40.0 / 36.0;
}
}  // namespace

BeamPlacing::BeamPlacing(const Look& look, const Values& values, Extent picture)
    : m_picture(picture), m_curvature(number_of(look, values, "curvature", 0.0)) {
    const double size = number_of(look, values, "screen_size", 1.0);
    const double shorter = std::min(picture.width, picture.height);
    const bool is_round = keeps_circles_round(look, values);
    m_size = {size * (is_round ? shorter / picture.width : 1.0),
              size * (is_round ? shorter / picture.height : 1.0)};
}

BeamPlace BeamPlacing::place_of(const PicturePixel& pixel) const {
    const double x = 2.0 * pixel[0] / m_picture.width - 1.0;
    const double y = 1.0 - 2.0 * pixel[1] / m_picture.height;
    return {x * pushed_out(y, m_curvature) / m_size[0], y * pushed_out(x, m_curvature) / m_size[1]};
}

PicturePixel BeamPlacing::pixel_of(const BeamPlace& place) const {
    const double on_glass[2] = {place[0] * m_size[0], place[1] * m_size[1]};
    double x = on_glass[0];
    double y = on_glass[1];
    constexpr int rounds = 40;  // each brings it nearer; even the strongest curve is there by then
    for (int i = 0; i < rounds; ++i) {
        const double next = on_glass[0] / pushed_out(y, m_curvature);
        y = on_glass[1] / pushed_out(x, m_curvature);
        x = next;
    }
    return {0.5 * (x + 1.0) * m_picture.width, 0.5 * (1.0 - y) * m_picture.height};
}

double BeamPlacing::pixel_size() const {
    return 2.0 / std::min(m_picture.width * m_size[0], m_picture.height * m_size[1]);
}
