#include "lab/drawing/beam_mapping.h"

#include "model/picture/beam_fit.h"

#include <algorithm>
#include <cmath>

namespace {
double number_of(const Look& look, const Values& values, const std::string& name, double fallback) {
    const Parameter* parameter = find_parameter(look, name);
    return parameter ? value_of(*parameter, values).numbers[0] : fallback;
}

// The name prefixes of the drawn looks, in order: "crt/".
std::vector<std::string> drawn_scopes(const Look& look) {
    std::vector<std::string> scopes;
    for (const Pass& pass : look.passes)
        if (scopes.empty() || scopes.back() != pass.scope)
            scopes.push_back(pass.scope);
    return scopes;
}

// A look uses the radial curve if its shaders contain it.
GlassDistortion glass_of(const Look& look, const Values& values, const std::string& scope) {
    const bool is_radial =
        std::any_of(look.passes.begin(), look.passes.end(), [&](const Pass& pass) {
            return pass.scope == scope &&
                   pass.fragment.text->find("barrel_radial(") != std::string::npos;
        });
    return {is_radial ? GlassDistortion::Kind::radial : GlassDistortion::Kind::crossed,
            number_of(look, values, scope + "curvature", 0.0)};
}

// The factor of the crossed curve along one axis, from the position along the other.
double pushed_out(double across, double amount) {
    return 1.0 + across * across * amount * 40.0 / 36.0;
}

BeamPosition shown_crossed(const BeamPosition& position, double amount) {
    BeamPosition shown = position;
    constexpr int rounds = 40;  // fixed-point iteration; converges even for the strongest curve
    for (int i = 0; i < rounds; ++i)
        shown = {position[0] / pushed_out(shown[1], amount),
                 position[1] / pushed_out(shown[0], amount)};
    return shown;
}

// Newton's method from beyond the root, as in barrel_radial_inverse().
BeamPosition shown_radial(const BeamPosition& position, double amount) {
    const double radius = std::hypot(position[0], position[1]);
    if (radius < 1e-12)
        return position;
    double root = std::min(std::max(radius, 1.0), radius / (1.0 - amount));
    for (int i = 0; i < 20; ++i) {
        const double square = amount * root * root;
        root -= (root * (1.0 - amount + square) - radius) / (1.0 - amount + 3.0 * square);
    }
    return {position[0] * root / radius, position[1] * root / radius};
}
}  // namespace

BeamPosition GlassDistortion::behind(const BeamPosition& position) const {
    const auto [x, y] = position;
    if (kind == Kind::crossed)
        return {x * pushed_out(y, amount), y * pushed_out(x, amount)};
    const double factor = 1.0 - amount + amount * (x * x + y * y);
    return {x * factor, y * factor};
}

BeamPosition GlassDistortion::shown(const BeamPosition& position) const {
    return kind == Kind::crossed ? shown_crossed(position, amount) : shown_radial(position, amount);
}

BeamMapping::BeamMapping(const Look& look, const Values& values, Extent picture,
                         std::optional<Fit> fit)
    : m_picture(picture) {
    const std::vector<std::string> scopes = drawn_scopes(look);
    for (const std::string& scope : scopes)
        if (const GlassDistortion glass = glass_of(look, values, scope); glass.amount != 0.0)
            m_glasses.push_back(glass);
    const std::string beam = scopes.empty() ? std::string() : scopes.front();
    const double size = number_of(look, values, beam + "screen_size", 1.0);
    const double shorter = std::min(picture.width, picture.height);
    const bool is_round = keeps_circles_round(look, values, beam);
    const std::array<double, 2> scale = beam_scale(look, values, picture, fit);
    m_size = {scale[0] * size * (is_round ? shorter / picture.width : 1.0),
              scale[1] * size * (is_round ? shorter / picture.height : 1.0)};
}

BeamPosition BeamMapping::position_of(const PicturePixel& pixel) const {
    BeamPosition position{2.0 * pixel[0] / m_picture.width - 1.0,
                          1.0 - 2.0 * pixel[1] / m_picture.height};
    std::for_each(m_glasses.rbegin(), m_glasses.rend(),
                  [&position](const GlassDistortion& glass) { position = glass.behind(position); });
    return {position[0] / m_size[0], position[1] / m_size[1]};
}

PicturePixel BeamMapping::pixel_of(const BeamPosition& position) const {
    BeamPosition shown{position[0] * m_size[0], position[1] * m_size[1]};
    for (const GlassDistortion& glass : m_glasses)
        shown = glass.shown(shown);
    return {0.5 * (shown[0] + 1.0) * m_picture.width, 0.5 * (1.0 - shown[1]) * m_picture.height};
}

double BeamMapping::pixel_size() const {
    return 2.0 / std::min(m_picture.width * m_size[0], m_picture.height * m_size[1]);
}
