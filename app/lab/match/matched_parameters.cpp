#include "lab/match/matched_parameters.h"

#include "lab/document/naming.h"
#include "model/plan/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace {
bool is_number(const Parameter& parameter) {
    return parameter.type.scalar == Scalar::floating && parameter.type.columns == 1 &&
           parameter.control != Control::event && !parameter.is_constant;
}

// Adds the full names of parameters; returns the names that the look lacks.
Diagnostics resolve(const std::vector<std::string>& names, const Look& look,
                    std::set<std::string>& full) {
    Diagnostics problems;
    for (const std::string& name : names) {
        const auto parameter = resolve_parameter(name, look);
        if (parameter)
            full.insert((*parameter)->name);
        else
            problems.insert(problems.end(), parameter.error().begin(), parameter.error().end());
    }
    return problems;
}

// The full names of the user's parameters.
struct ChosenNames {
    std::set<std::string> locked;
    std::set<std::string> fitted;
};

Result<ChosenNames> resolved(const MatchChoice& choice, const Look& look) {
    ChosenNames names;
    Diagnostics problems = resolve(choice.locked, look, names.locked);
    const Diagnostics more = resolve(choice.fitted, look, names.fitted);
    problems.insert(problems.end(), more.begin(), more.end());
    if (!problems.empty())
        return fail(std::move(problems));
    return names;
}

// Without those that only a video shows.
PhotoRole role_in_photos(const Parameter& parameter) {
    const PhotoRole role = parameter.photo_role;
    const bool is_for_videos = role == PhotoRole::tube || role == PhotoRole::decay;
    return is_for_videos ? PhotoRole::none : role;
}

std::vector<const Parameter*>& list_of(MatchedParameters& matched, PhotoRole role) {
    switch (role) {
        case PhotoRole::shape:
            return matched.shape;
        case PhotoRole::pitch:
            return matched.pitch;
        case PhotoRole::lines:
            return matched.lines;
        case PhotoRole::type:
            return matched.types;
        case PhotoRole::start:
            return matched.starts;
        case PhotoRole::off:
            return matched.hidden;
        default:
            return matched.amounts;
    }
}

Values all_values(const Document& document) {
    Values values;
    for (const Parameter& parameter : document.look().parameters)
        values[parameter.name] = document.value(parameter);
    return values;
}

void raise_from_identity(const Parameter& amount, Values& values) {
    constexpr double share = 0.4;
    Value& value = values.at(amount.name);
    if (value != amount.identity)
        return;
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        const Range& range = range_of(amount, i);
        value.numbers[i] = range.low + share * (range.high - range.low);
    }
}
}  // namespace

bool MatchedParameters::is_empty() const {
    return shape.empty() && pitch.empty() && lines.empty() && types.empty() && amounts.empty();
}

Result<MatchedParameters> matched_parameters(const Document& document, const MatchChoice& choice) {
    const Look& look = document.look();
    const auto names = resolved(choice, look);
    if (!names)
        return fail(names.error());
    Values values = all_values(document);  // with all patterns on
    for (const Parameter& parameter : look.parameters)
        if (parameter.photo_role == PhotoRole::amount && !names->locked.contains(parameter.name))
            raise_from_identity(parameter, values);
    MatchedParameters matched;
    for (const Parameter& parameter : look.parameters) {
        const bool is_wanted = names->fitted.contains(parameter.name);
        const PhotoRole role = role_in_photos(parameter);
        if (names->locked.contains(parameter.name) || !(is_wanted || role != PhotoRole::none))
            continue;
        const bool is_fixed = role == PhotoRole::start || role == PhotoRole::off;
        if (is_fixed && !is_wanted) {
            list_of(matched, role).push_back(&parameter);
            continue;
        }
        if (role != PhotoRole::type && !is_number(parameter))
            return fail({{},
                         0,
                         fmt::format("'{}' can't be found in a photo, because it is not a number "
                                     "with fractions.",
                                     parameter.name)});
        if (is_wanted || is_condition_true(parameter, look.parameters, values))
            list_of(matched, is_fixed ? PhotoRole::amount : role).push_back(&parameter);
    }
    if (matched.is_empty())
        return fail(
            {{},
             0,
             "This look does not say which parameters a photo shows. Name them with --fit."});
    return matched;
}

Result<MatchedParameters> decay_parameters(const Document& document, const MatchChoice& choice) {
    const Look& look = document.look();
    const auto names = resolved(choice, look);
    if (!names)
        return fail(names.error());
    MatchedParameters matched;
    for (const Parameter& parameter : look.parameters) {
        if (names->locked.contains(parameter.name))
            continue;
        if (parameter.photo_role == PhotoRole::tube)
            matched.tubes.push_back(&parameter);
        else if (parameter.photo_role == PhotoRole::decay)
            matched.decays.push_back(&parameter);
        else if (names->fitted.contains(parameter.name))
            matched.amounts.push_back(&parameter);
        else if (parameter.photo_role == PhotoRole::start)
            matched.starts.push_back(&parameter);
    }
    for (const auto* list : {&matched.decays, &matched.amounts})
        for (const Parameter* number : *list)
            if (!is_number(*number) || number->type.size() > 1)
                return fail({{},
                             0,
                             fmt::format("'{}' can't be found in a video, because it is not one "
                                         "number with fractions.",
                                         number->name)});
    if (matched.tubes.empty() && matched.decays.empty() && matched.amounts.empty())
        return fail({{},
                     0,
                     "This look does not say which parameters a video of fading light shows. Name "
                     "them with --fit."});
    return matched;
}

std::set<std::string> names_of_numbers(const MatchedParameters& parameters) {
    std::set<std::string> names;
    for (const auto* list :
         {&parameters.shape, &parameters.pitch, &parameters.lines, &parameters.amounts})
        for (const Parameter* number : *list)
            names.insert(number->name);
    return names;
}

std::vector<Unknown> unknowns_of(const std::vector<const Parameter*>& parameters) {
    std::vector<Unknown> unknowns;
    for (const Parameter* parameter : parameters)
        for (std::size_t i = 0; i < static_cast<std::size_t>(parameter->type.size()); ++i) {
            const Range& range = range_of(*parameter, i);
            const double width = range.high - range.low;
            unknowns.push_back({.part = Unknown::Part::look,
                                .index = i,
                                .parameter = parameter->name,
                                .low = range.low,
                                .high = range.high,
                                .difference = 0.02 * width,
                                .trust = 0.3 * width});
        }
    return unknowns;
}

Values starting_values(const Document& document, const MatchedParameters& parameters) {
    Values values = all_values(document);
    for (const Parameter* start : parameters.starts)
        values.at(start->name) = *start->photo_start;
    for (const Parameter* hidden : parameters.hidden)
        values.at(hidden->name) = *hidden->identity;
    for (const Parameter* amount : parameters.amounts)
        raise_from_identity(*amount, values);
    return values;
}
