#include "lab/match/photo_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace {
constexpr float point_weight = 3.0F;
constexpr float chroma_weight = 0.7F;

void append(std::vector<float>& numbers, const std::vector<glm::vec3>& values, float weight) {
    for (const glm::vec3& value : values) {
        numbers.push_back(weight * value.x);
        numbers.push_back(weight * chroma_weight * value.y);
        numbers.push_back(weight * chroma_weight * value.z);
    }
}

// The compared numbers in one row: tiles, then points.
std::vector<float> weighted(const SampleValues& values, Compared compared) {
    std::vector<float> numbers;
    numbers.reserve(3 * (values.tiles.size() + values.points.size()));
    if (compared.has_tiles)
        append(numbers, values.tiles, 1.0F);
    if (compared.has_points)
        append(numbers, values.points, point_weight);
    return numbers;
}

std::vector<float> difference_of(std::vector<float> one, const std::vector<float>& other,
                                 double divisor = 1.0) {
    const auto factor = static_cast<float>(1.0 / divisor);
    for (std::size_t i = 0; i < one.size(); ++i)
        one[i] = factor * (one[i] - other[i]);
    return one;
}

// The change of the residuals when the samples move on the photo by the difference of two places
// divided by `by`. A photo that fits has the slopes of what the camera sees, without the noise.
SampleValues moved_values(const SampleSlopes& slopes, const SamplePlaces& from,
                          const SamplePlaces& to, double by) {
    SampleValues change = slopes.across;
    for (std::size_t i = 0; i < change.tiles.size(); ++i) {
        const std::size_t tile = i / (std::size_t{SampleLayout::side} * SampleLayout::side);
        const glm::vec2 move(glm::inverse(from.tile_maps[tile]) * (to.tiles[i] - from.tiles[i]) /
                             by);
        change.tiles[i] = -(move.x * slopes.across.tiles[i] + move.y * slopes.down.tiles[i]);
    }
    for (std::size_t i = 0; i < change.points.size(); ++i) {
        const glm::vec2 move(glm::inverse(from.point_maps[i]) * (to.points[i] - from.points[i]) /
                             by);
        change.points[i] = -(move.x * slopes.across.points[i] + move.y * slopes.down.points[i]);
    }
    return change;
}

// The group of each compared number: its quarter of a tile, or the one next to its point.
std::vector<std::uint16_t> groups_of(const SampleLayout& layout, Compared compared) {
    std::vector<std::uint16_t> groups;
    constexpr int half = SampleLayout::side / 2;
    if (compared.has_tiles)
        for (int tile = 0; tile < layout.tile_count(); ++tile)
            for (int run = 0; run < 2 * SampleLayout::side; ++run)  // half a row
                groups.insert(
                    groups.end(), std::size_t{3} * half,
                    static_cast<std::uint16_t>(4 * tile + run / SampleLayout::side * 2 + run % 2));
    if (compared.has_points)
        for (int point = 0; point < layout.point_count(); ++point)
            groups.insert(groups.end(), 3,
                          static_cast<std::uint16_t>(layout.quarter_of_point(point)));
    return groups;
}

double mean_square(const std::vector<float>& residuals) {
    double sum = 0.0;
    for (const float residual : residuals)
        sum += static_cast<double>(residual) * static_cast<double>(residual);
    return sum / static_cast<double>(std::max<std::size_t>(residuals.size(), 1));
}

Picture joined_tiles(const SampleValues& values, const SampleLayout& layout) {
    Picture picture{layout.picture, 3, Encoding::linear, {}};
    picture.pixels.resize(picture.index(0, layout.picture.height));
    std::size_t next = 0;
    for (int tile = 0; tile < layout.tile_count(); ++tile)
        for (int y = 0; y < SampleLayout::side; ++y)
            for (int x = 0; x < SampleLayout::side; ++x, ++next) {
                const glm::ivec2 at = layout.origin(tile) + glm::ivec2(x, y);
                for (int channel = 0; channel < 3; ++channel)
                    picture.pixels[picture.index(at.x, at.y) + static_cast<std::size_t>(channel)] =
                        values.tiles[next][channel];
            }
    return picture;
}

Result<void> cancelled() {
    return fail({{}, 0, "cancelled"});
}
}  // namespace

/// What the camera of a state sees.
struct PhotoFit::View {
    const MatchState& state;
    Compared compared;
    const SampleLayout& layout;
    const ScreenLight& light;
    SamplePlaces places;
    SoftLight blurred;
    SampleSlopes slopes;
    std::vector<float> seen;
    std::vector<float> photo;
};

Result<const ScreenLight*> PhotoFit::light_of(const Values& values) {
    if (m_work.is_cancelled)
        return fail(cancelled().error());
    if (m_light.tiles.empty() || m_drawn != values) {
        auto light = m_renderer.light(values);
        if (!light)
            return fail(light.error());
        m_light = std::move(*light);
        m_drawn = values;
    }
    return &m_light;
}

// Only what is compared.
SampleLayout PhotoFit::layout_for(Compared compared) const {
    const SampleLayout& layout = m_renderer.layout();
    if (!compared.has_tiles)
        return layout.without_tiles();
    return compared.has_points ? layout : layout.without_points();
}

Result<double> PhotoFit::cost(const MatchState& state, Compared compared) {
    const auto all = residuals(state, compared);
    return all ? Result<double>(mean_square(*all)) : fail(all.error());
}

Result<std::vector<float>> PhotoFit::residuals(const MatchState& state, Compared compared) {
    const auto light = light_of(state.values);
    if (!light)
        return fail(light.error());
    const SampleLayout layout = layout_for(compared);
    const SamplePlaces places(layout, state.camera, m_photo.extent());
    const auto seen = weighted(
        developed(blurred(**light, state.camera, layout, places), state.camera, layout, places),
        compared);
    return difference_of(seen, weighted(photographed(m_photo, layout, places), compared));
}

// The derivatives by a number that moves the samples on the photo. Exact ones come from the photo,
// from both sides, because noise would change the slope of the cost from one side. Points hardly
// have noise.
Derivatives PhotoFit::moved_column(const View& view, const Unknown& unknown, double by) const {
    MatchState other = view.state;
    unknown.set(other, unknown.of(view.state) - by);
    const SamplePlaces before(view.layout, other.camera, m_photo.extent());
    unknown.set(other, unknown.of(view.state) + by);
    const SamplePlaces after(view.layout, other.camera, m_photo.extent());
    auto smooth = weighted(moved_values(view.slopes, view.places, after, by), view.compared);
    if (!view.compared.has_tiles)
        return {std::move(smooth), {}};
    constexpr Compared only_tiles{true, false};
    const SampleLayout tiles = view.layout.without_points();
    auto exact = difference_of(weighted(photographed(m_photo, tiles, before), only_tiles),
                               weighted(photographed(m_photo, tiles, after), only_tiles), 2.0 * by);
    exact.insert(exact.end(), smooth.begin() + static_cast<std::ptrdiff_t>(exact.size()),
                 smooth.end());
    return {std::move(smooth), std::move(exact)};
}

// The derivatives of all compared numbers by one unknown.
Result<Derivatives> PhotoFit::column(const View& view, const Unknown& unknown) {
    const SampleLayout& layout = view.layout;
    const double now = unknown.of(view.state);
    const double by =
        now + unknown.difference <= unknown.high ? unknown.difference : -unknown.difference;
    MatchState other = view.state;
    unknown.set(other, now + by);
    if (unknown.is_geometric())
        return moved_column(view, unknown, by);
    if (unknown.part == Unknown::Part::look)
        return look_column(view, unknown, by);
    const auto seen =
        unknown.part == Unknown::Part::blur || unknown.part == Unknown::Part::sharpening
            ? developed(blurred(view.light, other.camera, layout, view.places), other.camera,
                        layout, view.places)
            : developed(view.blurred, other.camera, layout, view.places);
    return Derivatives{difference_of(weighted(seen, view.compared), view.seen, by), {}};
}

// The derivatives by a number of the look.
Result<Derivatives> PhotoFit::look_column(const View& view, const Unknown& unknown, double by) {
    const auto seen_with = [&](double value) -> Result<std::vector<float>> {
        Values values = view.state.values;
        values.at(unknown.parameter).numbers.at(unknown.index) = value;
        const auto light = m_renderer.light(values);
        if (!light)
            return fail(light.error());
        const SampleLayout& layout = view.layout;
        const Camera& camera = view.state.camera;
        return weighted(
            developed(blurred(*light, camera, layout, view.places), camera, layout, view.places),
            view.compared);
    };
    const double now = unknown.of(view.state);
    auto after = seen_with(now + by);
    if (!after)
        return fail(after.error());
    if (!unknown.is_central || now - by < unknown.low || now - by > unknown.high)
        return Derivatives{difference_of(std::move(*after), view.seen, by), {}};
    const auto before = seen_with(now - by);
    if (!before)
        return fail(before.error());
    return Derivatives{difference_of(std::move(*after), *before, 2.0 * by), {}};
}

Result<std::vector<NormalEquations>> PhotoFit::linearised(const MatchState& state,
                                                          const std::vector<Unknown>& unknowns,
                                                          Compared compared) {
    const auto light = light_of(state.values);
    if (!light)
        return fail(light.error());
    const SampleLayout layout = layout_for(compared);
    SamplePlaces places(layout, state.camera, m_photo.extent());
    SoftLight soft = blurred(**light, state.camera, layout, places);
    auto seen = weighted(developed(soft, state.camera, layout, places), compared);
    SampleSlopes slopes = developed_slopes(soft, state.camera, layout, places);
    auto photo = weighted(photographed(m_photo, layout, places), compared);
    const std::vector<float> residuals = difference_of(seen, photo);
    const View view{
        state,           compared,          layout,          **light,         std::move(places),
        std::move(soft), std::move(slopes), std::move(seen), std::move(photo)};
    std::vector<Derivatives> columns;
    for (const Unknown& unknown : unknowns) {
        if (m_work.is_cancelled)
            return fail(cancelled().error());
        auto made = column(view, unknown);
        if (!made)
            return fail(made.error());
        columns.push_back(std::move(*made));
    }
    return summed(columns, residuals, groups_of(layout, compared),
                  4 * static_cast<std::size_t>(m_renderer.layout().tile_count()));
}

Result<Picture> PhotoFit::seen_picture(const MatchState& state) {
    if (m_work.is_cancelled)
        return fail(cancelled().error());
    const SampleLayout layout = SampleLayout::dense(m_renderer.layout().picture);
    const auto light = m_renderer.light(state.values, layout);
    if (!light)
        return fail(light.error());
    const SamplePlaces places(layout, state.camera, m_photo.extent());
    return joined_tiles(
        developed(blurred(*light, state.camera, layout, places), state.camera, layout, places),
        layout);
}

Picture PhotoFit::photographed_picture(const Camera& camera) const {
    const SampleLayout layout = SampleLayout::dense(m_renderer.layout().picture);
    return joined_tiles(
        photographed(m_photo, layout, SamplePlaces(layout, camera, m_photo.extent())), layout);
}

Result<double> PhotoFit::explained_share(const MatchState& state, Compared compared) {
    const auto missing = residuals(state, compared);
    if (!missing)
        return fail(missing.error());
    const SampleLayout layout = layout_for(compared);
    const auto photo = weighted(
        photographed(m_photo, layout, SamplePlaces(layout, state.camera, m_photo.extent())),
        compared);
    double mean = 0.0;
    for (std::size_t i = 0; i < photo.size(); i += 3)  // luma
        mean += static_cast<double>(photo[i]) * 3.0 / static_cast<double>(photo.size());
    double variation = 0.0;
    double error = 0.0;
    for (std::size_t i = 0; i < photo.size(); i += 3) {
        variation += std::pow(static_cast<double>(photo[i]) - mean, 2);
        error += std::pow(static_cast<double>((*missing)[i]), 2);
    }
    return variation > 0.0 ? 1.0 - error / variation : 0.0;
}

Result<double> PhotoFit::minimise(MatchState& state, const std::vector<Unknown>& unknowns,
                                  Compared compared, int steps, double precision) {
    class Problem : public LeastSquares {
    public:
        Problem(PhotoFit& fit, Compared compared) : m_fit(fit), m_compared(compared) {}
        Result<double> cost(const MatchState& at) override { return m_fit.cost(at, m_compared); }
        Result<std::vector<NormalEquations>> linearised(const MatchState& at,
                                                        const std::vector<Unknown>& by) override {
            return m_fit.linearised(at, by, m_compared);
        }

    private:
        PhotoFit& m_fit;
        Compared m_compared;
    };
    Problem problem(*this, compared);
    return ::minimise(problem, state, unknowns, steps, precision);
}
