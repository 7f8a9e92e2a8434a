#include "base/text.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
Diagnostic problem(std::string message) {
    return {{}, 0, std::move(message)};
}

Diagnostic unknown_kind(const std::string& name) {
    std::vector<std::string> known;
    for (const SignalKind& kind : signal_kinds())
        known.push_back(kind.kind);
    const std::string guess = did_you_mean(name, known);
    return problem(guess.empty() ? fmt::format("unknown signal '{}'; use one of: {}", name,
                                               fmt::join(known, ", "))
                                 : fmt::format("unknown signal '{}'{}", name, guess));
}

Diagnostic unknown_setting(const SignalKind& kind, const std::string& key) {
    std::vector<std::string> known;
    for (const SettingInfo& setting : kind.settings)
        known.push_back(setting.key);
    const std::string guess = did_you_mean(key, known);
    return problem(guess.empty()
                       ? fmt::format("{}: unknown setting '{}'; use one of: {}", kind.kind, key,
                                     fmt::join(known, ", "))
                       : fmt::format("{}: unknown setting '{}'{}", kind.kind, key, guess));
}

std::string text_of(const Spec::Setting& value) {
    const double* number = std::get_if<double>(&value);
    return number ? format_number(*number) : std::get<std::string>(value);
}

// These functions return a description of the problem, or "".
std::string number_problem(const SettingInfo& info, const Spec::Setting& value) {
    const double* number = std::get_if<double>(&value);
    if (!number || !std::isfinite(*number))
        return fmt::format("'{}' must be a number, got '{}'", info.key, text_of(value));
    if (*number < info.limit.low || *number > info.limit.high)
        return fmt::format("'{}' must be between {} and {}, got {}", info.key,
                           format_number(info.limit.low), format_number(info.limit.high),
                           format_number(*number));
    if (info.step == 1.0 && *number != std::floor(*number))
        return fmt::format("'{}' must be a whole number, got {}", info.key, format_number(*number));
    return {};
}

std::string word_problem(const SettingInfo& info, const Spec::Setting& value) {
    const std::string word = text_of(value);
    if (std::find(info.words.begin(), info.words.end(), word) != info.words.end())
        return {};
    return fmt::format("'{}' must be one of '{}', got '{}'{}", info.key,
                       fmt::join(info.words, "', '"), word, did_you_mean(word, info.words));
}

std::string value_problem(const SettingInfo& info, const Spec::Setting& value) {
    switch (info.type) {
        case SettingType::number:
            return number_problem(info, value);
        case SettingType::word:
            return word_problem(info, value);
        case SettingType::text:
            return text_of(value).empty() && !info.may_be_empty
                       ? fmt::format("'{}' is required", info.key)
                       : std::string();
    }
    return {};
}

Spec::Setting initial_of(const SettingInfo& info) {
    if (info.type == SettingType::number)
        return info.initial;
    return info.initial_word;
}

// Moves the bare first word to the key that it stands for.
Result<Spec> with_bare_word_named(const SignalKind& kind, Spec spec) {
    const auto bare = spec.settings.find("");
    if (bare == spec.settings.end())
        return spec;
    const std::string word = text_of(bare->second);
    if (kind.bare_setting.empty() && !word.empty())
        return fail(problem(fmt::format("{}: expected key=value, got '{}'", kind.kind, word)));
    if (!word.empty() && !spec.settings.emplace(kind.bare_setting, word).second)
        return fail(problem(fmt::format("{}: '{}' is given twice", kind.kind, kind.bare_setting)));
    spec.settings.erase("");
    return spec;
}
}  // namespace

Result<Spec> completed(const Spec& given) {
    const SignalKind* kind = find_kind(given.kind);
    if (!kind)
        return fail(unknown_kind(given.kind));
    auto named = with_bare_word_named(*kind, given);
    if (!named)
        return named;

    Diagnostics problems;
    for (const auto& [key, value] : named->settings)
        if (!find_setting(*kind, key))
            problems.push_back(unknown_setting(*kind, key));

    Spec complete{kind->kind, {}};
    for (const SettingInfo& info : kind->settings) {
        const auto found = named->settings.find(info.key);
        Spec::Setting value = found == named->settings.end() ? initial_of(info) : found->second;
        const std::string wrong = value_problem(info, value);
        if (!wrong.empty())
            problems.push_back(problem(fmt::format("{}: {}", kind->kind, wrong)));
        if (info.type != SettingType::number)
            value = text_of(value);
        complete.settings.emplace(info.key, std::move(value));
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return complete;
}
