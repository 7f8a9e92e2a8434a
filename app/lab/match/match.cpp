#include "lab/match/match.h"

#include "lab/match/pattern_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
constexpr Compared only_points{false, true};
constexpr Compared all{true, true};
// Errors that a whole photo shares disturb contrasts more than positions. Measured on synthetic
// photos, see docs/match.md.
constexpr double period_scale = 0.6;
constexpr double shape_scale = 1.2;
constexpr double amount_scale = 1.5;

void append(std::vector<Unknown>& to, const std::vector<Unknown>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

double farthest(const Corners& some, const Corners& others) {
    double distance = 0.0;
    for (std::size_t i = 0; i < some.size(); ++i)
        distance = std::max(distance, glm::length(some[i] - others[i]));
    return distance;
}

// As `--corners` takes them.
std::string corner_list(const Corners& corners) {
    std::vector<std::string> numbers;
    for (const glm::dvec2& corner : corners) {
        numbers.push_back(fmt::format("{:.0f}", corner.x));
        numbers.push_back(fmt::format("{:.0f}", corner.y));
    }
    return fmt::format("{}", fmt::join(numbers, ","));
}

class Stages {
public:
    Stages(PhotoFit& fit, const MatchRequest& request)
        : m_fit(fit), m_search(fit), m_request(request), m_state(request.start) {}

    Result<Matched> run() {
        for (const auto stage :
             {&Stages::find_exposure, &Stages::find_shape, &Stages::check_corner_positions,
              &Stages::find_type, &Stages::compare_types, &Stages::find_lines,
              &Stages::compare_types, &Stages::check_visible, &Stages::find_all})
            if (auto done = (this->*stage)(); !done)
                return is_stopped() ? Result<Matched>(stopped()) : fail(done.error());
        return finished();
    }

private:
    const MatchedParameters& parameters() const { return m_request.parameters; }

    const Parameter* pitch() const {
        return parameters().pitch.empty() ? nullptr : parameters().pitch.front();
    }

    Result<void> refused(std::string why) const {
        return fail({m_request.photo, 0, std::move(why)});
    }

    void report(std::string stage, double residual) {
        m_residual = residual;
        if (!m_request.on_progress)
            return;
        MatchProgress progress{std::move(stage), m_state, std::sqrt(residual), {}};
        if (m_request.draws_pictures)  // without them when cancelled
            if (auto pictures = match_pictures(m_fit, m_state))
                progress.pictures = std::move(*pictures);
        m_request.on_progress(progress);
    }

    bool is_stopped() const { return m_fit.work().is_cancelled && m_residual.has_value(); }

    Matched stopped() const {
        Matched matched{
            m_state, {}, std::sqrt(m_residual.value_or(0.0)), m_fit.renderer().count(), false};
        for (const Unknown& unknown : all_unknowns())
            if (unknown.part == Unknown::Part::look) {
                const double value = unknown.of(m_state);
                matched.numbers.push_back({unknown.parameter, unknown.index, value, value, value,
                                           "the match was stopped"});
            }
        return matched;
    }

    // The colour matrix and the vignette.
    Result<void> find_exposure() {
        auto residual = fit_exposure(m_state, 4);
        if (!residual)
            return fail(residual.error());
        report("Exposure", *residual);
        return {};
    }

    Result<double> fit_exposure(MatchState& state, int steps) {
        std::vector<Unknown> unknowns = exposure_unknowns();
        unknowns.pop_back();  // gamma
        return m_fit.minimise(state, unknowns, only_points, steps);
    }

    Result<void> find_shape() {
        for (const Unknown& unknown : unknowns_of(parameters().shape))
            if (auto done = scan(unknown); !done)
                return done;
        const auto residual = fit_shape(m_state, 4.0 * m_request.corner_deviation);
        if (!residual)
            return fail(residual.error());
        report("Shape and camera", *residual);
        return {};
    }

    // The best of some values, with the exposure that fits each.
    Result<void> scan(const Unknown& unknown) {
        constexpr int count = 9;
        double best = std::numeric_limits<double>::infinity();
        MatchState best_state = m_state;
        for (int i = 0; i < count; ++i) {
            MatchState state = m_state;
            unknown.set(state, unknown.low + (unknown.high - unknown.low) * i / (count - 1));
            const auto cost = fit_exposure(state, 2);
            if (!cost)
                return fail(cost.error());
            if (*cost < best) {
                best = *cost;
                best_state = state;
            }
        }
        m_state = best_state;
        report("Shape", best);
        return {};
    }

    // Shape, geometry and exposure by mean light.
    Result<double> fit_shape(MatchState& state, double corner_deviation) {
        std::vector<Unknown> unknowns = shape_unknowns(0.01);
        append(unknowns, geometry_unknowns(m_request.start.camera, corner_deviation));
        append(unknowns, exposure_unknowns());
        return m_fit.minimise(state, unknowns, only_points, 25, 1e-5);
    }

    // Fails if the photo does not show the source, or shows it at other corners.
    Result<void> check_corner_positions() {
        constexpr double least_explained = 0.8;
        constexpr double likely_errors = 5.0;
        constexpr double wide = 25.0;
        constexpr double much_better = 0.5;
        constexpr double fits_well = 0.998;
        const auto near_share = m_fit.explained_share(m_state, only_points);
        if (!near_share)
            return fail(near_share.error());
        if (*near_share > fits_well)
            return {};
        MatchState other = m_state;
        const auto residual = fit_shape(other, wide * m_request.corner_deviation);
        if (!residual)
            return fail(residual.error());
        const auto share = m_fit.explained_share(other, only_points);
        if (!share)
            return fail(share.error());
        if (*share < least_explained)
            return refused(
                fmt::format("The photo does not show this source at these corners: only {:.0f} % "
                            "of its light and dark agree. Check the source and the corners.",
                            100.0 * std::max(*share, 0.0)));
        const double distance = farthest(other.camera.corners, m_request.start.camera.corners);
        if (distance > likely_errors * m_request.corner_deviation &&
            *residual < much_better * m_residual.value_or(0.0)) {
            if (m_request.on_better_corners)
                m_request.on_better_corners(other.camera.corners);
            return refused(
                fmt::format("The corners are {:.0f} px off. Check them: the source fits better "
                            "near {}.",
                            distance, corner_list(other.camera.corners)));
        }
        return {};
    }

    // `share`: of the range, for derivatives.
    std::vector<Unknown> shape_unknowns(double share) const {
        std::vector<Unknown> unknowns = unknowns_of(parameters().shape);
        for (Unknown& unknown : unknowns) {
            unknown.interval_scale = shape_scale;
            unknown.difference = share * (unknown.high - unknown.low);
            unknown.is_central = true;
            unknown.trust = 15.0 * unknown.difference;
        }
        return unknowns;
    }

    std::vector<Unknown> camera_unknowns() const {
        std::vector<Unknown> unknowns = blur_unknowns();
        append(unknowns, exposure_unknowns());
        append(unknowns, geometry_unknowns(m_request.start.camera, m_request.corner_deviation));
        return unknowns;
    }

    // A quick fit of what shows a pattern. The camera may move, because a mask needs a precision
    // that mean light does not have.
    Result<double> fit_pattern(MatchState& state, const Parameter* period) {
        std::vector<const Parameter*> amounts;
        for (const Parameter* amount : parameters().amounts)
            if (!period || amount->group == period->group)
                amounts.push_back(amount);
        std::vector<Unknown> unknowns = unknowns_of(amounts);
        if (period)
            append(unknowns, period_unknowns({period}, state));
        append(unknowns, shape_unknowns(0.001));
        append(unknowns, camera_unknowns());
        return m_fit.minimise(state, unknowns, all, 8, 1e-3);
    }

    // Tries the strongest period of each type first. A fit of a wrong mask still improves the
    // camera, so a second search can find a mask that the first one missed.
    Result<void> find_type() {
        if (!pitch())
            return compare_fits_of_types();
        for (const std::size_t most_tried : {1, 3}) {
            const auto is_taken = take_visible(most_tried);
            if (!is_taken)
                return fail(is_taken.error());
            if (*is_taken)
                return {};
        }
        return no_mask();
    }

    MatchState with_type(const Parameter* type, double value) const {
        MatchState state = m_state;
        if (type)
            state.values.at(type->name).numbers.front() = value;
        return state;
    }

    // For looks without a pitch to find.
    Result<void> compare_fits_of_types() {
        Candidate best{std::numeric_limits<double>::infinity(), m_state};
        for (const auto& [type, value] : types()) {
            MatchState state = with_type(type, value);
            const auto cost = fit_pattern(state, nullptr);
            if (!cost)
                return fail(cost.error());
            if (*cost < best.cost)
                best = {*cost, std::move(state)};
        }
        m_state = best.state;
        report("Mask", best.cost);
        return {};
    }

    // Fits the most likely types and periods, until the photo shows one.
    Result<bool> take_visible(std::size_t most_tried) {
        std::vector<Candidate> candidates;
        for (const auto& [type, value] : types()) {
            const auto found =
                m_search.candidates(with_type(type, value), *pitch(), Along::rows, most_tried);
            if (!found)
                return fail(found.error());
            candidates.insert(candidates.end(), found->begin(), found->end());
        }
        std::ranges::sort(candidates, {}, &Candidate::cost);
        candidates.resize(std::min(candidates.size(), most_tried));
        for (Candidate& candidate : candidates) {
            if (auto taken = take(std::move(candidate), *pitch(), "Mask"); !taken)
                return fail(taken.error());
            auto visible = is_visible();
            if (!visible || *visible)
                return visible;
        }
        return false;
    }

    // Whether the photo shows the mask of the state.
    Result<bool> is_visible() {
        constexpr double least_evidence = 5.0;
        const auto evidence = m_search.evidence(m_state, *pitch());
        return evidence ? Result<bool>(*evidence >= least_evidence) : fail(evidence.error());
    }

    // Checks the mask again after the scanlines are fitted, which can look like a mask.
    Result<void> check_visible() {
        if (!pitch())
            return {};
        const auto visible = is_visible();
        if (!visible)
            return fail(visible.error());
        return *visible ? Result<void>() : no_mask();
    }

    Result<void> no_mask() const {
        return refused(
            "The photo does not show the mask. Take it from closer, so that a triad of "
            "stripes is at least 3 px wide.");
    }

    // Fits a candidate.
    Result<void> take(Candidate candidate, const Parameter& period, const std::string& stage) {
        const auto cost = fit_pattern(candidate.state, &period);
        if (!cost)
            return fail(cost.error());
        m_state = std::move(candidate.state);
        report(stage, *cost);
        return {};
    }

    // Compares the types again, now that the camera is known well.
    Result<void> compare_types() {
        if (parameters().types.empty() || !pitch())
            return {};
        const auto best = m_search.best_type(m_state, *pitch(), types());
        if (!best)
            return fail(best.error());
        if (best->state.values == m_state.values)
            return {};
        return take(*best, *pitch(), "Mask");
    }

    std::vector<std::pair<const Parameter*, double>> types() const {
        std::vector<std::pair<const Parameter*, double>> all_types;
        for (const Parameter* type : parameters().types)
            for (const Item& item : type->items)
                all_types.emplace_back(type, item.value);
        if (all_types.empty())
            all_types.emplace_back(nullptr, 0.0);
        return all_types;
    }

    Result<void> find_lines() {
        if (parameters().lines.empty())
            return {};
        const Parameter& lines = *parameters().lines.front();
        auto candidates = m_search.candidates(m_state, lines, Along::columns, 3);
        if (!candidates)
            return fail(candidates.error());
        if (candidates->empty())  // their interval will be wide
            return {};
        return take(*std::ranges::min_element(*candidates, {}, &Candidate::cost), lines,
                    "Scanlines");
    }

    // Differences of periods must move the last stripe by a small part of a period.
    std::vector<Unknown> period_unknowns(const std::vector<const Parameter*>& periods,
                                         const MatchState& state) const {
        std::vector<Unknown> unknowns = unknowns_of(periods);
        const double width = m_fit.renderer().layout().picture.width;
        for (std::size_t i = 0; i < unknowns.size(); ++i) {
            const double value = unknowns[i].of(state);
            const double px = m_search.px_of(state, *periods[i], value);
            unknowns[i].interval_scale = period_scale;
            unknowns[i].difference = 0.05 * value * px / width;
            unknowns[i].is_central = true;
            unknowns[i].trust = 0.25 * value * px / width;
        }
        return unknowns;
    }

    std::vector<Unknown> all_unknowns() const {
        std::vector<Unknown> unknowns = unknowns_of(parameters().amounts);
        for (Unknown& amount : unknowns)
            amount.interval_scale = amount_scale;
        append(unknowns, period_unknowns(parameters().pitch, m_state));
        append(unknowns, period_unknowns(parameters().lines, m_state));
        append(unknowns, shape_unknowns(0.001));
        append(unknowns, camera_unknowns());
        return unknowns;
    }

    Result<void> find_all() {
        const auto residual = m_fit.minimise(m_state, all_unknowns(), all, 20, 1e-4);
        if (!residual)
            return fail(residual.error());
        report("All", *residual);
        return {};
    }

    Result<Matched> finished() {
        const std::vector<Unknown> unknowns = all_unknowns();
        const auto groups = m_fit.linearised(m_state, unknowns, all);
        if (!groups)
            return fail(groups.error());
        const NormalEquations sum = sum_of(*groups);
        constexpr Compared only_tiles{true, false};
        const auto explained = m_fit.explained_share(m_state, only_tiles);
        if (!explained)
            return fail(explained.error());
        return Matched{m_state,
                       found_numbers(unknowns, m_state, covariance(sum, *groups)),
                       std::sqrt(m_residual.value_or(0.0)),
                       m_fit.renderer().count(),
                       true,
                       *explained};
    }

    PhotoFit& m_fit;
    PatternSearch m_search;
    const MatchRequest& m_request;
    MatchState m_state;
    std::optional<double> m_residual;  // mean square; nullopt: before the first stage
};
}  // namespace

std::string explained_text(const Matched& matched) {
    return fmt::format(
        "The look explains {:.1f} % of the light and dark that were compared. The rest is noise, "
        "and what the look can't draw.",
        100.0 * std::max(matched.explained, 0.0));
}

Result<Matched> match_photo(PhotoFit& fit, const MatchRequest& request) {
    return Stages(fit, request).run();
}
