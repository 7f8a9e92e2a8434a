#include "model/photo/camera.h"

#include <fmt/format.h>

#include <cmath>

namespace {
constexpr double min_side = 48.0;  // px

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

// The projective map of the unit square to four corners (Heckbert 1989, section 2.2.3).
glm::dmat3 square_to(const Corners& corners) {
    const glm::dvec2 one = corners[1] - corners[2];
    const glm::dvec2 two = corners[3] - corners[2];
    const glm::dvec2 sum = corners[0] - corners[1] + corners[2] - corners[3];
    const double area = cross(one, two);
    const double g = cross(sum, two) / area;
    const double h = cross(one, sum) / area;
    const glm::dvec2 across = corners[1] - corners[0] + g * corners[1];
    const glm::dvec2 down = corners[3] - corners[0] + h * corners[3];
    return {glm::dvec3(across, g), glm::dvec3(down, h), glm::dvec3(corners[0], 1.0)};
}

// The radius whose image through the lens is `seen`, by Newton's method.
double radius_before_lens(double seen, double lens) {
    double radius = seen;
    for (int i = 0; i < 8; ++i)
        radius -=
            (radius * (1.0 + lens * radius * radius) - seen) / (1.0 + 3.0 * lens * radius * radius);
    return radius;
}
}  // namespace

Corners corners_of(Extent photo) {
    const double width = photo.width;
    const double height = photo.height;
    return {glm::dvec2(0.0, 0.0), glm::dvec2(width, 0.0), glm::dvec2(width, height),
            glm::dvec2(0.0, height)};
}

Result<void> check_corners(const Corners& corners, Extent photo) {
    const glm::dvec2 end(photo.width, photo.height);
    for (const glm::dvec2& corner : corners)
        if (glm::any(glm::lessThan(corner, -0.1 * end)) ||
            glm::any(glm::greaterThan(corner, 1.1 * end)))
            return fail({{},
                         0,
                         fmt::format("The corner {:.0f},{:.0f} is outside the photo. The photo has "
                                     "{} x {} px.",
                                     corner.x, corner.y, photo.width, photo.height)});
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 side = corners[(i + 1) % 4] - corners[i];
        if (glm::length(side) < min_side)
            return fail({{}, 0, "Two corners are too close. Place them at the screen's corners."});
        if (cross(side, corners[(i + 2) % 4] - corners[(i + 1) % 4]) <= 0.0)
            return fail({{},
                         0,
                         "The corners are crossed or mirrored. Give them clockwise from the "
                         "screen's top left corner."});
    }
    return {};
}

ScreenMap::ScreenMap(const Camera& camera, Extent photo)
    : m_centre(0.5 * photo.width, 0.5 * photo.height),
      m_unit(glm::length(m_centre)),
      m_lens(camera.lens) {
    Corners undistorted = camera.corners;
    for (glm::dvec2& corner : undistorted) {
        const glm::dvec2 from_centre = (corner - m_centre) / m_unit;
        const double seen = glm::length(from_centre);
        if (seen > 0.0)
            corner = m_centre + m_unit * from_centre * (radius_before_lens(seen, m_lens) / seen);
    }
    m_perspective = square_to(undistorted);
}

glm::dvec2 ScreenMap::photo_at(glm::dvec2 place) const {
    const glm::dvec3 projected = m_perspective * glm::dvec3(place, 1.0);
    const glm::dvec2 from_centre = (glm::dvec2(projected) / projected.z - m_centre) / m_unit;
    const double square = glm::dot(from_centre, from_centre);
    return m_centre + m_unit * from_centre * (1.0 + m_lens * square);
}

glm::dmat2 ScreenMap::slope_at(glm::dvec2 place, Extent picture) const {
    constexpr double step = 1e-3;
    const glm::dvec2 across =
        photo_at(place + glm::dvec2(step, 0.0)) - photo_at(place - glm::dvec2(step, 0.0));
    const glm::dvec2 down =
        photo_at(place + glm::dvec2(0.0, step)) - photo_at(place - glm::dvec2(0.0, step));
    return {across / (2.0 * step * picture.width), down / (2.0 * step * picture.height)};
}

double ScreenMap::squared_radius(glm::dvec2 position) const {
    const glm::dvec2 from_centre = (position - m_centre) / m_unit;
    return glm::dot(from_centre, from_centre);
}
