#include "lab/match/decay_match.h"

#include "lab/match/match_job.h"
#include "lab/match/phosphor_responses.h"
#include "model/photo/decay_likelihood.h"
#include "model/plan/condition.h"
#include "model/tuning/slider_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
struct Explanation {
    Values values;
    DecayLikelihood likelihood;
};

class DecaySearch {
public:
    DecaySearch(PhosphorResponses& responses, const RecordedDecay& recorded,
                const MatchedParameters& parameters)
        : m_responses(responses), m_recorded(recorded), m_parameters(parameters) {}

    Result<void> run(DecayMatch& match);

private:
    using Numbers = std::vector<const Parameter*>;

    Result<DecayLikelihood> likelihood(const Values& values);
    Numbers numbers_in_effect(const Numbers& among, const Values& values) const;
    Result<Explanation> fitted(Values values, const Numbers& numbers);
    Result<Explanation> compare_tubes(DecayMatch& match);
    Result<void> fit_number(const Parameter& number, Explanation& explanation);
    Result<FoundNumber> found(const Parameter& number, const Explanation& best);

    PhosphorResponses& m_responses;
    const RecordedDecay& m_recorded;
    const MatchedParameters& m_parameters;
};

Result<DecayLikelihood> DecaySearch::likelihood(const Values& values) {
    const int frames =
        static_cast<int>(m_recorded.curve.light.size()) + std::max(m_recorded.lit_frames, 1) + 1;
    const auto response = m_responses.response(values, frames);
    if (!response)
        return fail(response.error());
    return decay_likelihood(m_recorded, *response, PhosphorResponses::steps);
}

DecaySearch::Numbers DecaySearch::numbers_in_effect(const Numbers& among,
                                                    const Values& values) const {
    const std::vector<Parameter>& all = m_responses.document().look().parameters;
    Numbers numbers;
    for (const Parameter* number : among)
        if (is_condition_true(*number, all, values))
            numbers.push_back(number);
    return numbers;
}

// The best position of a slider: nine of them, then a golden section.
Result<void> DecaySearch::fit_number(const Parameter& number, Explanation& explanation) {
    constexpr int count = 9;
    constexpr int sections = 10;
    constexpr double golden = 0.6180339887;
    const Range& range = range_of(number, 0);
    const auto at = [&](double ratio) -> Result<Explanation> {
        Explanation there{explanation.values, {}};
        there.values.at(number.name).numbers.front() = value_at(range, number.scale, ratio);
        auto found = likelihood(there.values);
        if (!found)
            return fail(found.error());
        there.likelihood = *found;
        return there;
    };
    double best_ratio = 0.0;
    explanation.likelihood.logarithm = -std::numeric_limits<double>::infinity();
    const auto take = [&](double ratio) -> Result<double> {
        auto there = at(ratio);
        if (!there)
            return fail(there.error());
        const double logarithm = there->likelihood.logarithm;
        if (logarithm > explanation.likelihood.logarithm) {
            explanation = std::move(*there);
            best_ratio = ratio;
        }
        return logarithm;
    };
    for (int i = 0; i < count; ++i)
        if (auto taken = take(i / (count - 1.0)); !taken)
            return fail(taken.error());
    double low = std::max(best_ratio - 1.0 / (count - 1.0), 0.0);
    double high = std::min(best_ratio + 1.0 / (count - 1.0), 1.0);
    auto left = take(high - golden * (high - low));
    auto right = take(low + golden * (high - low));
    for (int i = 0; i < sections && left && right; ++i)
        if (*left > *right) {
            high = low + golden * (high - low);
            right = left;
            left = take(high - golden * (high - low));
        } else {
            low = high - golden * (high - low);
            left = right;
            right = take(low + golden * (high - low));
        }
    if (!left || !right)
        return fail(left ? right.error() : left.error());
    return {};
}

Result<Explanation> DecaySearch::fitted(Values values, const Numbers& numbers) {
    Explanation explanation{std::move(values), {}};
    for (const Parameter* number : numbers)
        if (auto done = fit_number(*number, explanation); !done)
            return fail(done.error());
    if (numbers.empty()) {
        auto found = likelihood(explanation.values);
        if (!found)
            return fail(found.error());
        explanation.likelihood = *found;
    }
    return explanation;
}

// The most likely item. One with a number to find needs a likelihood that is much better.
Result<Explanation> DecaySearch::compare_tubes(DecayMatch& match) {
    constexpr double much_better = 10.0;  // logarithm
    constexpr double fits_well = 2.0;     // misfit
    const Parameter& list = *m_parameters.tubes.front();
    Explanation best{{}, {-std::numeric_limits<double>::infinity(), 0.0}};
    std::vector<double> logarithms;
    Values all = starting_values(m_responses.document(), m_parameters);
    for (const bool is_measured : {true, false})
        for (const Item& item : list.items) {
            all.at(list.name).numbers.front() = item.value;
            const Numbers numbers = numbers_in_effect(m_parameters.decays, all);
            if (numbers.empty() != is_measured)
                continue;
            if (!is_measured && best.likelihood.misfit < fits_well && !match.tubes.empty())
                continue;  // a measured tube explains the light
            auto explanation = fitted(all, numbers);
            if (!explanation)
                return explanation;
            const double logarithm = explanation->likelihood.logarithm;
            if (is_measured) {
                match.tubes.push_back({item.label, 0.0});
                logarithms.push_back(logarithm);
            }
            if (logarithm > best.likelihood.logarithm + (is_measured ? 0.0 : much_better)) {
                best = std::move(*explanation);
                match.tube = item.label;
            }
        }
    const double most = logarithms.empty() ? 0.0 : std::ranges::max(logarithms);
    double sum = 0.0;
    for (const double logarithm : logarithms)
        sum += std::exp(logarithm - most);
    for (std::size_t i = 0; i < logarithms.size(); ++i)
        match.tubes[i].probability = std::exp(logarithms[i] - most) / sum;
    std::ranges::stable_sort(match.tubes, std::greater{}, &TubeProbability::probability);
    return best;
}

// The interval from the curvature of the likelihood, wider if the light does not fit well.
Result<FoundNumber> DecaySearch::found(const Parameter& number, const Explanation& best) {
    constexpr double normal_90 = 1.6449;
    constexpr double step = 0.004;  // of the slider
    const Range& range = range_of(number, 0);
    const double value = best.values.at(number.name).number();
    const double ratio = ratio_in(range, number.scale, value);
    FoundNumber result{number.name, 0, value, value, value, {}};
    if (ratio < step || ratio > 1.0 - step) {
        result.why_not = "the best value is at the end of the slider's range";
        return result;
    }
    double sides = 0.0;
    for (const double at : {ratio - step, ratio + step}) {
        Values values = best.values;
        values.at(number.name).numbers.front() = value_at(range, number.scale, at);
        const auto there = likelihood(values);
        if (!there)
            return fail(there.error());
        sides += there->logarithm;
    }
    const double curvature = (2.0 * best.likelihood.logarithm - sides) / (step * step);
    const double excess = std::max(best.likelihood.misfit, 1.0);
    const double half = curvature > 0.0 ? normal_90 * std::sqrt(excess / curvature) : 1.0;
    result.low = value_at(range, number.scale, std::max(ratio - half, 0.0));
    result.high = value_at(range, number.scale, std::min(ratio + half, 1.0));
    if (half > 0.1)
        result.why_not = "the video hardly shows it";
    return result;
}

Result<void> DecaySearch::run(DecayMatch& match) {
    Result<Explanation> best = Explanation();
    if (!m_parameters.tubes.empty()) {
        match.tube_parameter = m_parameters.tubes.front()->name;
        best = compare_tubes(match);
    } else {
        const Values all = starting_values(m_responses.document(), m_parameters);
        best = fitted(all, numbers_in_effect(m_parameters.decays, all));
    }
    if (!best)
        return fail(best.error());
    Numbers numbers = numbers_in_effect(m_parameters.decays, best->values);
    for (const Parameter* number : numbers_in_effect(m_parameters.amounts, best->values)) {
        if (auto done = fit_number(*number, *best); !done)
            return done;
        numbers.push_back(number);
    }
    for (const Parameter* number : numbers) {
        auto result = found(*number, *best);
        if (!result)
            return fail(result.error());
        match.numbers.push_back(*result);
        match.values[number->name] = best->values.at(number->name);
    }
    for (const Parameter* start : m_parameters.starts)
        match.values[start->name] = best->values.at(start->name);
    if (!match.tube_parameter.empty())
        match.values[match.tube_parameter] = best->values.at(match.tube_parameter);
    match.misfit = best->likelihood.misfit;
    return {};
}
}  // namespace

Result<DecayMatch> match_decay(PreparedLook prepared, const VideoOfDecay& video,
                               const MatchChoice& choice, JobProgress& work) {
    const Document document = prepared.document;
    const auto parameters = decay_parameters(document, choice);
    if (!parameters)
        return fail(parameters.error());
    const auto light = read_light(video, work);
    if (!light)
        return fail(light.error());
    auto recorded = recorded_decay(light->curve);
    if (!recorded) {
        Diagnostics problems = recorded.error();
        problems.front().file = video.file;
        return fail(std::move(problems));
    }
    auto responses = PhosphorResponses::create(std::move(prepared), light->curve.fps, work);
    if (!responses)
        return fail(responses.error());
    DecayMatch match;
    match.at = light->at;
    match.fps = light->curve.fps;
    match.frames = static_cast<int>(recorded->curve.light.size());
    match.lit_frames = recorded->lit_frames;
    match.constants = time_constants(*recorded);
    if (auto done = DecaySearch(*responses, *recorded, *parameters).run(match); !done)
        return fail(done.error());
    return match;
}

std::string misfit_text(const DecayMatch& match) {
    constexpr double bad = 4.0;
    return match.misfit < bad ? std::string()
                              : "No decay of this look fits the video well. Its light fades "
                                "differently, or the exposure was not locked.";
}

Result<DecayFile> match_decay_file(const RenderRequest& render, const VideoOfDecay& video,
                                   const MatchChoice& choice, const Library& library,
                                   JobProgress& work) {
    auto prepared = prepare(render, library);
    if (!prepared)
        return fail(prepared.error());
    DecayFile result{prepared->document, {}, prepared->warnings};
    auto match = match_decay(std::move(*prepared), video, choice, work);
    if (!match)
        return fail(match.error());
    result.match = std::move(*match);
    set_found(result.document, result.match.values);
    return result;
}
