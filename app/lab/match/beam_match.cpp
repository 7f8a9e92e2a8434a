#include "lab/match/beam_match.h"

#include "lab/match/beam_fit.h"
#include "model/photo/beam_places.h"
#include "model/picture/difference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
// Of the lens and the sensor of a sharp photo, px.
constexpr double usual_blur = 1.0;
constexpr double blur_deviation = 0.4;

Result<std::vector<BeamPattern>> find_patterns(const Picture& photo, const LightMap& map,
                                               const MatchRequest& request, int lines) {
    const Corners& corners = request.start.camera.corners;
    const double height =
        0.5 * (glm::length(corners[3] - corners[0]) + glm::length(corners[2] - corners[1]));
    const double reach = BeamRenderer::profile_reach * height;
    const BeamPlaces places = find_beam_places(photo, map, corners, reach);
    std::vector<BeamPattern> patterns;
    for (const auto& place : {places.line, places.dot})
        if (place)
            patterns.push_back(
                pattern_at(*place, reach, request.start.camera, photo.extent, lines));
    if (!patterns.empty())
        return patterns;
    return fail({request.photo, 0,
                 places.are_overexposed
                     ? "The lines and dots of the beam are overexposed. Take a photo with less "
                       "exposure."
                     : "The photo shows neither a straight line nor an isolated dot. Show one, "
                       "with dark screen around it."});
}

std::vector<Unknown> unknowns_at(const std::vector<const Parameter*>& amounts,
                                 const MatchState& state) {
    std::vector<Unknown> unknowns = unknowns_of(amounts);
    for (Unknown& unknown : unknowns)
        unknown.difference =
            std::max(0.05 * std::abs(unknown.of(state)), 0.002 * (unknown.high - unknown.low));
    return unknowns;
}

class BeamStages {
public:
    BeamStages(BeamFit& fit, const BeamRenderer& renderer, const MatchRequest& request,
               JobProgress& work)
        : m_fit(fit), m_renderer(renderer), m_request(request), m_work(work) {
        m_state = request.start;
        m_state.camera.blur = usual_blur;
    }

    Result<MatchedWithPictures> run() {
        const auto residual = find_best();
        if (!residual)
            return fail(residual.error());
        const auto pictures = report("Camera's blur", m_state);
        const auto explained = m_fit.explained_share(m_state);
        if (!pictures || !explained)
            return fail(pictures ? explained.error() : pictures.error());
        MatchedWithPictures found{{m_state, {}, rms_of(*pictures), 0, true, *explained}, *pictures};
        if (auto numbers = intervals())
            found.matched.numbers = std::move(*numbers);
        else if (!m_work.is_cancelled)
            return fail(numbers.error());
        else
            found.matched = stopped(found.matched);
        found.matched.pictures = m_renderer.count();
        return found;
    }

private:
    static constexpr int steps = 15;

    struct Start {
        double cost = 0.0;
        MatchState state;
    };

    // Fits from the best of many states, because widths can take each other's place. The values of
    // the document are one of them.
    Result<double> find_best() {
        constexpr int states = 24;
        constexpr std::size_t fitted = 5;
        constexpr int first_steps = 2;
        std::vector<Start> starts;
        for (int i = 0; i < states; ++i) {
            Start start{0.0, i == 0 ? m_state : spread_state(i)};
            if (auto done = update(start, m_fit.cost(start.state)); !done)
                return fail(done.error());
            starts.push_back(std::move(start));
            if (i == 0)
                if (auto reported = report("First values", m_state); !reported)
                    return fail(reported.error());
        }
        std::ranges::sort(starts, {}, &Start::cost);
        starts.resize(fitted);
        for (Start& start : starts)
            if (auto done = update(start, fit(start.state, first_steps)); !done)
                return fail(done.error());
        const Start& best = *std::ranges::min_element(starts, {}, &Start::cost);
        if (auto reported = report("Width and bloom", best.state); !reported)
            return fail(reported.error());
        m_state = best.state;
        return fit(m_state, steps);
    }

    Result<MatchPictures> report(std::string stage, const MatchState& state) {
        auto pictures = m_fit.pictures(state);
        if (pictures && m_request.on_progress)
            m_request.on_progress({std::move(stage), state, rms_of(*pictures), *pictures});
        return pictures;
    }

    // Of display values. Both have the same size.
    static double rms_of(const MatchPictures& pictures) {
        return difference_between(pictures.photo, pictures.seen, 0.0).value().rms;
    }

    static Result<void> update(Start& start, const Result<double>& cost) {
        if (!cost)
            return fail(cost.error());
        start.cost = *cost;
        return {};
    }

    // Evenly spread over the ranges of the sliders (Halton 1960).
    MatchState spread_state(int number) const {
        constexpr std::array bases{2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
        MatchState state = m_state;
        std::size_t next = 0;
        for (const Parameter* amount : m_request.parameters.amounts)
            for (const Unknown& unknown : unknowns_of({amount})) {
                const double share = halton(number, bases.at(next++ % bases.size()));
                const bool is_log = amount->scale == Scale::logarithmic && unknown.low > 0.0;
                unknown.set(state, is_log
                                       ? unknown.low * std::pow(unknown.high / unknown.low, share)
                                       : unknown.low + share * (unknown.high - unknown.low));
            }
        return state;
    }

    static double halton(int number, int base) {
        double share = 0.0;
        double digit = 1.0;
        for (int rest = number; rest > 0; rest /= base) {
            digit /= base;
            share += digit * (rest % base);
        }
        return share;
    }

    Result<double> fit(MatchState& state, int most_steps) {
        constexpr double precision = 1e-3;
        return minimise(m_fit, state, unknowns_at(m_request.parameters.amounts, state), most_steps,
                        precision);
    }

    // From the errors of the profiles, and from what other blurs of the camera would give.
    Result<std::vector<FoundNumber>> intervals() {
        std::vector<Unknown> unknowns = unknowns_at(m_request.parameters.amounts, m_state);
        const std::size_t count = unknowns.size();
        const auto groups = m_fit.linearised(m_state, unknowns);
        if (!groups)
            return fail(groups.error());
        const std::vector<double> of_noise = covariance(sum_of(*groups), *groups);
        const auto by_blur = change_by_blur(unknowns);
        if (!by_blur)
            return fail(by_blur.error());
        unknowns.push_back({.part = Unknown::Part::blur, .low = 0.0, .high = 5.0});
        std::vector<double> all((count + 1) * (count + 1));
        for (std::size_t i = 0; i <= count; ++i)
            for (std::size_t j = 0; j <= count; ++j)
                all[i * (count + 1) + j] = (*by_blur)[i] * (*by_blur)[j] +
                                           (i < count && j < count ? of_noise[i * count + j] : 0.0);
        return found_numbers(unknowns, m_state, all);
    }

    // How much each number, and last the blur, change by a standard deviation of the blur.
    Result<std::vector<double>> change_by_blur(const std::vector<Unknown>& unknowns) {
        MatchState sharp = m_state;
        sharp.camera.blur -= blur_deviation;
        MatchState soft = m_state;
        soft.camera.blur += blur_deviation;
        for (MatchState* state : {&sharp, &soft})
            if (auto residual = fit(*state, steps); !residual)
                return fail(residual.error());
        std::vector<double> changes;
        for (const Unknown& unknown : unknowns)
            changes.push_back(0.5 * (unknown.of(soft) - unknown.of(sharp)));
        changes.push_back(blur_deviation);
        return changes;
    }

    Matched stopped(Matched matched) const {
        matched.is_complete = false;
        for (const Unknown& unknown : unknowns_of(m_request.parameters.amounts)) {
            const double value = unknown.of(m_state);
            matched.numbers.push_back(
                {unknown.parameter, unknown.index, value, value, value, "the match was stopped"});
        }
        return matched;
    }

    BeamFit& m_fit;
    const BeamRenderer& m_renderer;
    const MatchRequest& m_request;
    JobProgress& m_work;
    MatchState m_state;
};
}  // namespace

Result<MatchedWithPictures> match_beam(BeamRenderer& renderer, const Picture& photo,
                                       const MatchRequest& request, JobProgress& work) {
    const LightMap map = light_of_photo(photo, request.start.camera.gamma);
    const auto patterns = find_patterns(photo, map, request, renderer.lines());
    if (!patterns)
        return fail(patterns.error());
    BeamFit fit(renderer, map, *patterns, work);
    return BeamStages(fit, renderer, request, work).run();
}
