#include "lab/match/pattern_search.h"

#include "model/picture/aliasing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
constexpr Compared only_tiles{true, false};

double& number_of(MatchState& state, const Parameter& parameter) {
    return state.values.at(parameter.name).numbers.front();
}

Picture difference_of(Picture one, const Picture& other) {
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        one.pixels[i] -= other.pixels[i];
    return one;
}

// The least mean square of a mixture of residuals without and with a pattern: that of the pattern's
// best amount, if its effect is proportional to the amount.
double least_mixed(const std::vector<float>& without, const std::vector<float>& with) {
    double square = 0.0;   // of the pattern's effect
    double product = 0.0;  // of its effect and what is missing without it
    double cost = 0.0;
    for (std::size_t i = 0; i < without.size(); ++i) {
        const auto missing = static_cast<double>(without[i]);
        const double effect = static_cast<double>(with[i]) - missing;
        cost += missing * missing;
        square += effect * effect;
        product -= missing * effect;
    }
    if (product > 0.0)
        cost -= product * product / square;
    return cost / static_cast<double>(std::max<std::size_t>(without.size(), 1));
}

// What a pattern changes in a tile without its mean, squared and multiplied by what is missing.
struct TileEffect {
    double square = 0.0;
    double product = 0.0;

    TileEffect& operator+=(const TileEffect& other) {
        square += other.square;
        product += other.product;
        return *this;
    }
};

std::vector<TileEffect> tile_effects(const std::vector<float>& without,
                                     const std::vector<float>& with) {
    constexpr std::size_t per_tile = std::size_t{SampleLayout::side} * SampleLayout::side;
    std::vector<TileEffect> tiles(without.size() / (3 * per_tile));
    for (std::size_t i = 0; i < 3 * tiles.size(); ++i) {  // tile and channel
        const std::size_t first = i / 3 * 3 * per_tile + i % 3;
        double missing = 0.0;  // sums
        double effect = 0.0;
        TileEffect sum;
        for (std::size_t at = first; at < first + 3 * per_tile; at += 3) {
            const auto lacks = -static_cast<double>(without[at]);
            const double changes = static_cast<double>(with[at]) + lacks;
            missing += lacks;
            effect += changes;
            sum += {changes * changes, lacks * changes};
        }
        const auto count = static_cast<double>(per_tile);
        sum += {-effect * effect / count, -missing * effect / count};
        tiles[i / 3] += sum;
    }
    return tiles;
}
}  // namespace

double PatternSearch::px_of(const MatchState& state, const Parameter& period, double value) const {
    const PeriodTerms terms{
        m_fit.renderer().look(), state.values, m_fit.renderer().layout().picture, {}};
    return period_of(period, value, terms).value_or(value);
}

MatchState PatternSearch::without_pattern(const MatchState& state, const Parameter& period) const {
    MatchState without = state;
    for (const Parameter& parameter : m_fit.renderer().look().parameters)
        if (parameter.photo_role == PhotoRole::amount && parameter.group == period.group &&
            parameter.identity)
            without.values[parameter.name] = *parameter.identity;
    return without;
}

// The shortest period that a photo shows, in px of the look's picture.
double PatternSearch::min_period(const MatchState& state) const {
    constexpr double photo_px = 3.0;
    const ScreenMap map(state.camera, m_fit.photo().extent());
    const glm::dmat2 slope = map.slope_at(glm::dvec2(0.5, 0.5), m_fit.renderer().layout().picture);
    return photo_px / std::max(glm::length(slope[0]), glm::length(slope[1]));
}

// Values whose period the photo has, most likely first.
Result<std::vector<double>> PatternSearch::measured_values(const MatchState& state,
                                                           const Parameter& period, Along along,
                                                           std::size_t count) {
    const auto without = m_fit.seen_picture(without_pattern(state, period));
    if (!without)
        return fail(without.error());
    const Range& range = range_of(period, 0);
    double shortest = px_of(state, period, range.low);
    double longest = px_of(state, period, range.high);
    if (shortest > longest)
        std::swap(shortest, longest);
    shortest = std::max(shortest, min_period(state));
    const PeriodSpectrum of_photo =
        period_spectrum(difference_of(m_fit.photographed_picture(state.camera), *without), along);
    std::vector<double> values;
    for (const double measured : peak_periods(of_photo, shortest, longest, count)) {
        const auto value = value_with_period(state, period, along, measured, of_photo, *without);
        if (!value)
            return fail(value.error());
        const bool is_new = std::ranges::none_of(
            values, [&](double other) { return std::abs(*value / other - 1.0) < 0.01; });
        if (is_new)
            values.push_back(*value);
    }
    return values;
}

// Draws with a value and corrects it by the ratio of the periods in photo and picture, which are
// measured alike.
Result<double> PatternSearch::value_with_period(MatchState state, const Parameter& parameter,
                                                Along along, double measured,
                                                const PeriodSpectrum& of_photo,
                                                const Picture& without) {
    const double unit = px_of(state, parameter, 1.0);
    const bool is_inverse = px_of(state, parameter, 2.0) < unit;  // such as triads across
    double period = measured;
    for (int i = 0; i < 2; ++i) {
        number_of(state, parameter) = is_inverse ? unit / period : period / unit;
        auto with = m_fit.seen_picture(state);
        if (!with)
            return fail(with.error());
        period *= period_ratio(
            of_photo, period_spectrum(difference_of(std::move(*with), without), along), measured);
    }
    return is_inverse ? unit / period : period / unit;
}

// The best of some values near one. Neighbours differ by a third of a period at the picture's end,
// so one of them has nearly the right phase everywhere. `without`: the residuals without the
// pattern.
Result<Candidate> PatternSearch::scanned(const MatchState& state, const Parameter& period,
                                         double value, const std::vector<float>& without) {
    constexpr int reach = 2;
    const Extent size = m_fit.renderer().layout().picture;
    const double step = 0.3 * px_of(state, period, value) / std::max(size.width, size.height);
    Candidate best{std::numeric_limits<double>::infinity(), state};
    for (int i = -reach; i <= reach; ++i) {
        MatchState near = state;
        number_of(near, period) = value * (1.0 + i * step);
        const auto with = m_fit.residuals(near, only_tiles);
        if (!with)
            return fail(with.error());
        if (const double cost = least_mixed(without, *with); cost < best.cost)
            best = {cost, std::move(near)};
    }
    return best;
}

Result<std::vector<Candidate>> PatternSearch::candidates(const MatchState& state,
                                                         const Parameter& period, Along along,
                                                         std::size_t count) {
    const auto values = measured_values(state, period, along, count);
    if (!values)
        return fail(values.error());
    const auto without = m_fit.residuals(without_pattern(state, period), only_tiles);
    if (!without)
        return fail(without.error());
    std::vector<Candidate> found;
    for (const double value : *values) {
        auto candidate = scanned(state, period, value, *without);
        if (!candidate)
            return fail(candidate.error());
        found.push_back(std::move(*candidate));
    }
    return found;
}

Result<Candidate> PatternSearch::best_type(
    const MatchState& state, const Parameter& period,
    const std::vector<std::pair<const Parameter*, double>>& types) {
    const auto without = m_fit.residuals(without_pattern(state, period), only_tiles);
    if (!without)
        return fail(without.error());
    Candidate best{std::numeric_limits<double>::infinity(), state};
    for (const auto& [type, value] : types) {
        MatchState other = state;
        number_of(other, *type) = value;
        const auto with = m_fit.residuals(other, only_tiles);
        if (!with)
            return fail(with.error());
        if (const double cost = least_mixed(*without, *with); cost < best.cost)
            best = {cost, std::move(other)};
    }
    return best;
}

Result<double> PatternSearch::evidence(const MatchState& state, const Parameter& period) {
    const auto with = m_fit.residuals(state, only_tiles);
    if (!with)
        return fail(with.error());
    const auto without = m_fit.residuals(without_pattern(state, period), only_tiles);
    if (!without)
        return fail(without.error());
    const std::vector<TileEffect> tiles = tile_effects(*without, *with);
    TileEffect sum;
    for (const TileEffect& tile : tiles)
        sum += tile;
    if (sum.square <= 0.0)
        return 0.0;
    const double amount = sum.product / sum.square;
    double variance = 0.0;
    for (const TileEffect& tile : tiles)
        variance += std::pow(tile.product - amount * tile.square, 2);
    return variance > 0.0 ? sum.product / std::sqrt(variance) : 0.0;
}
