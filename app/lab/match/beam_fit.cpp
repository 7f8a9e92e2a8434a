#include "lab/match/beam_fit.h"

#include "lab/match/photo_check.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double dimmest = 0.01;  // of the middle: dimmer light is not compared more closely

// The part around a place that its profile reads, with the camera's blur.
LightMap part_around(const LightMap& map, BeamPlace& place, double reach, double blur) {
    const int half = static_cast<int>(std::ceil(1.5 * reach + 4.0 * blur)) + 2;
    const glm::ivec2 origin = glm::ivec2(glm::floor(place.at)) - half;
    LightMap part{{2 * half + 1, 2 * half + 1}, {}};
    for (int y = 0; y < part.extent.height; ++y)
        for (int x = 0; x < part.extent.width; ++x)
            part.light.push_back(map.at(glm::dvec2(origin + glm::ivec2(x, y)) + 0.5));
    place.at -= glm::dvec2(origin);
    return blurred(part, blur);
}

// Gain and background by weighted least squares.
glm::dvec2 best_line(const std::vector<double>& from, const std::vector<double>& to,
                     const std::vector<double>& weights) {
    double sum = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double weight = weights[i] * weights[i];
        sum += weight;
        x += weight * from[i];
        y += weight * to[i];
        xx += weight * from[i] * from[i];
        xy += weight * from[i] * to[i];
    }
    const double determinant = sum * xx - x * x;
    if (determinant <= 0.0)
        return {0.0, y / sum};
    const double gain = (sum * xy - x * y) / determinant;
    return {gain, (y - gain * x) / sum};
}

// Draws the light around a place as display values: a square as high as the picture, after `left`
// px. `px`: of the light per px of the picture.
void draw_square(Picture& picture, int left, const LightMap& light, const BeamPlace& place,
                 double px, glm::dvec2 gain) {
    const glm::dvec2 along = place.is_line() ? place.along : glm::dvec2(1.0, 0.0);
    const glm::dvec2 across(-along.y, along.x);
    const int side = picture.extent.height;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::dvec2 from = px * (glm::dvec2(x, y) - 0.5 * (side - 1));
            const auto seen =
                static_cast<double>(light.at(place.at + from.x * along + from.y * across));
            const double value = std::pow(std::clamp(gain.x * seen + gain.y, 0.0, 1.0), 1.0 / 2.2);
            std::fill_n(&picture.pixels[picture.index(left + x, y)], 3, static_cast<float>(value));
        }
}
}  // namespace

BeamPattern pattern_at(const BeamPlace& photographed, double reach, const Camera& camera,
                       Extent photo, int lines) {
    constexpr int rounds = 20;
    const ScreenMap map(camera, photo);
    const Extent seen = screen_size(camera.corners);
    const Extent picture{seen.width * lines / seen.height, lines};
    const glm::dvec2 size(picture.width, picture.height);
    glm::dvec2 place(0.5);
    for (int round = 0; round < rounds; ++round)
        place += glm::inverse(map.slope_at(place, picture)) *
                 (photographed.at - map.photo_at(place)) / size;
    const glm::dmat2 to_picture = glm::inverse(map.slope_at(place, picture));
    if (!photographed.is_line())
        return {photographed, reach, {}, std::sqrt(std::abs(glm::determinant(to_picture)))};
    const glm::dvec2 along = glm::normalize(to_picture * photographed.along);
    const glm::dvec2 across(-photographed.along.y, photographed.along.x);
    const glm::dvec2 drawn_across(-along.y, along.x);
    return {photographed, reach, along, glm::dot(to_picture * across, drawn_across)};
}

BeamFit::BeamFit(BeamRenderer& renderer, const LightMap& photo,
                 const std::vector<BeamPattern>& patterns, JobProgress& work)
    : m_renderer(renderer), m_photo(photo), m_work(work) {
    for (const BeamPattern& pattern : patterns) {
        Compared compared{
            pattern, beam_profile(photo, pattern.photographed, pattern.reach), {}, {}};
        compared.mean = compared.photo.mean();
        const double most = std::ranges::max(compared.mean);
        for (const double light : compared.mean)
            compared.weights.push_back(1.0 / std::sqrt(most * (light + dimmest * most)));
        m_compared.push_back(std::move(compared));
    }
}

Result<BeamFit::Seen> BeamFit::flash(const MatchState& state, const Compared& compared) {
    if (m_work.is_cancelled)
        return fail({{}, 0, "cancelled"});
    const BeamPattern& pattern = compared.pattern;
    const double reach = pattern.scale * pattern.reach;
    const auto light = m_renderer.flash(state.values, pattern.along, reach, compared.seconds);
    if (!light)
        return fail(light.error());
    Seen seen{{}, {m_renderer.middle(), pattern.along}, {}};
    seen.light = part_around(*light, seen.place, reach, pattern.scale * state.camera.blur);
    seen.profile = beam_profile(seen.light, seen.place, reach).mean();
    return seen;
}

// Flashes until the middle is as bright as in the photo. The tone map of a look may be anything
// that rises, so the slope comes from the last two flashes.
Result<BeamFit::Seen> BeamFit::seen(const MatchState& state, Compared& compared) {
    constexpr int most_flashes = 12;
    constexpr double near = 0.1;
    constexpr double shortest = 1e-9;
    constexpr double longest = 1.0 / BeamRenderer::fps;
    const double target = std::log(std::ranges::max(compared.mean));
    double slope = 1.0;  // of the logarithm of light
    double last_light = 0.0;
    double last_seconds = 0.0;
    Result<Seen> seen = flash(state, compared);
    for (int i = 1; i < most_flashes && seen; ++i) {
        const double light = std::log(std::max(std::ranges::max(seen->profile), 1e-9));
        if (std::abs(light - target) < near)
            break;
        const double now = std::log(compared.seconds);
        if (i > 1 && std::abs(now - last_seconds) > 1e-6)
            slope = std::clamp((light - last_light) / (now - last_seconds), 0.2, 2.0);
        last_light = light;
        last_seconds = now;
        const double seconds =
            std::clamp(std::exp(now + (target - light) / slope), shortest, longest);
        if (seconds == compared.seconds)  // the look can't be as bright
            break;
        compared.seconds = seconds;
        seen = flash(state, compared);
    }
    if (!seen)
        return seen;
    const glm::dvec2 line = best_line(seen->profile, compared.mean, compared.weights);
    seen->gain = line.x;
    seen->background = line.y;
    return seen;
}

Result<std::vector<float>> BeamFit::residuals(const MatchState& state) {
    std::vector<float> all;
    for (Compared& compared : m_compared) {
        const auto there = seen(state, compared);
        if (!there)
            return fail(there.error());
        for (const auto& piece : compared.photo.light)
            for (std::size_t i = 0; i < piece.size(); ++i)
                all.push_back(
                    static_cast<float>(compared.weights[i] * (there->gain * there->profile[i] +
                                                              there->background - piece[i])));
    }
    return all;
}

Result<double> BeamFit::cost(const MatchState& state) {
    const auto all = residuals(state);
    if (!all)
        return fail(all.error());
    double sum = 0.0;
    for (const float residual : *all)
        sum += std::pow(static_cast<double>(residual), 2);
    return sum / static_cast<double>(all->size());
}

Result<std::vector<NormalEquations>> BeamFit::linearised(const MatchState& state,
                                                         const std::vector<Unknown>& unknowns) {
    const auto here = residuals(state);
    if (!here)
        return fail(here.error());
    std::vector<Derivatives> columns;
    for (const Unknown& unknown : unknowns) {
        const double now = unknown.of(state);
        const double by =
            now + unknown.difference <= unknown.high ? unknown.difference : -unknown.difference;
        MatchState other = state;
        unknown.set(other, now + by);
        auto there = residuals(other);
        if (!there)
            return fail(there.error());
        for (std::size_t i = 0; i < there->size(); ++i)
            (*there)[i] = ((*there)[i] - (*here)[i]) / static_cast<float>(by);
        columns.push_back({std::move(*there)});
    }
    std::vector<std::uint16_t> groups;
    for (std::size_t i = 0; i < here->size(); ++i)
        groups.push_back(static_cast<std::uint16_t>(i / BeamProfile::values));
    return summed(columns, *here, groups, m_compared.size() * BeamProfile::pieces);
}

Result<double> BeamFit::explained_share(const MatchState& state) {
    const auto missing = cost(state);
    if (!missing)
        return fail(missing.error());
    double variation = 0.0;
    std::size_t count = 0;
    for (const Compared& compared : m_compared) {
        const std::vector<double> none(compared.mean.size(), 0.0);
        const double level = best_line(none, compared.mean, compared.weights).y;
        for (const auto& piece : compared.photo.light)
            for (std::size_t i = 0; i < piece.size(); ++i, ++count)
                variation += std::pow(compared.weights[i] * (piece[i] - level), 2);
    }
    return 1.0 - *missing * static_cast<double>(count) / std::max(variation, 1e-12);
}

Result<MatchPictures> BeamFit::pictures(const MatchState& state) {
    constexpr double most = 200.0;
    const int half = static_cast<int>(std::min(m_compared.front().pattern.reach, most));
    const int side = 2 * half + 1;
    Picture empty{{side * static_cast<int>(m_compared.size()), side}, 3, Encoding::display, {}};
    empty.pixels.resize(empty.index(0, side));
    MatchPictures pictures{empty, empty};
    int left = 0;
    for (Compared& compared : m_compared) {
        const auto there = seen(state, compared);
        if (!there)
            return fail(there.error());
        const BeamPattern& pattern = compared.pattern;
        const double px = pattern.reach / half;  // of the photo
        draw_square(pictures.photo, left, m_photo, pattern.photographed, px, {1.0, 0.0});
        draw_square(pictures.seen, left, there->light, there->place, px * pattern.scale,
                    {there->gain, there->background});
        left += side;
    }
    return pictures;
}
