#include "lab/document/changes.h"

#include "base/text.h"
#include "model/look/value_text.h"
#include "model/picture/source_spec.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace {
// Values with the same short text get as many digits as necessary to distinguish them.
Change change_of(const Parameter& parameter, const Value& before, const Value& after) {
    constexpr int max_digits = 17;
    Change change{parameter.name, parameter.label, {}, {}, unit_text(parameter)};
    for (int digits = 4; digits <= max_digits && change.before == change.after; ++digits) {
        change.before = value_text(parameter, before, digits);
        change.after = value_text(parameter, after, digits);
    }
    return change;
}

std::string orphan_text(const Values& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? "not set" : to_string(found->second);
}

void add_values(const Look& look, const Values& before, const Values& after,
                std::vector<Change>& changes) {
    for (const Parameter& parameter : look.parameters) {
        const Value& old_value = value_of(parameter, before);
        const Value& new_value = value_of(parameter, after);
        if (old_value != new_value)
            changes.push_back(change_of(parameter, old_value, new_value));
    }
    std::set<std::string> others;
    for (const Values* values : {&before, &after})
        for (const std::string& name : orphans(look, *values))
            others.insert(name);
    for (const std::string& name : others) {
        const std::string old_text = orphan_text(before, name);
        const std::string new_text = orphan_text(after, name);
        if (old_text != new_text)
            changes.push_back({name, name, old_text, new_text, {}});
    }
}

std::string modulation_text(const Modulations& modulations, const std::string& name) {
    const auto found = modulations.find(name);
    return found == modulations.end() ? "none" : summary_of(found->second);
}

void add_modulations(const Look& look, const Modulations& before, const Modulations& after,
                     std::vector<Change>& changes) {
    std::set<std::string> names;
    for (const Modulations* modulations : {&before, &after})
        for (const auto& [name, modulation] : *modulations)
            names.insert(name);
    for (const std::string& name : names) {
        const std::string old_text = modulation_text(before, name);
        const std::string new_text = modulation_text(after, name);
        const Parameter* parameter = find_parameter(look, name);
        if (old_text != new_text)
            changes.push_back({name,
                               fmt::format("Modulation of {}", parameter ? parameter->label : name),
                               old_text,
                               new_text,
                               {}});
    }
}

std::string setting_text(const Spec::Setting& setting) {
    if (const auto* number = std::get_if<double>(&setting))
        return format_number(*number);
    constexpr std::size_t maximum = 24;
    std::string text = std::get<std::string>(setting);
    if (text.find('/') != std::string::npos && text.find('\n') == std::string::npos)
        text = std::filesystem::path(text).filename().string();
    if (text.size() <= maximum)
        return text;
    std::size_t end = maximum;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
        --end;  // not within a UTF-8 character
    return text.substr(0, end) + "…";
}

std::string kind_label(const Spec& spec) {
    const SignalKind* kind = find_kind(spec.kind);
    return kind ? kind->label : spec.kind.empty() ? "none" : spec.kind;
}

void add_signal(const Spec& before, const Spec& after, std::vector<Change>& changes) {
    const Spec old_spec = completed(before).value_or(before);
    const Spec new_spec = completed(after).value_or(after);
    if (old_spec.kind != new_spec.kind) {
        changes.push_back({{}, "Signal", kind_label(before), kind_label(after), {}});
        return;
    }
    const SignalKind* kind = find_kind(new_spec.kind);
    std::set<std::string> keys;
    for (const Spec* spec : {&old_spec, &new_spec})
        for (const auto& [key, setting] : spec->settings)
            keys.insert(key);
    const auto text_of = [](const Spec& spec, const std::string& key) {
        const auto found = spec.settings.find(key);
        return found == spec.settings.end() ? "not set" : setting_text(found->second);
    };
    for (const std::string& key : keys) {
        const auto old_setting = old_spec.settings.find(key);
        const auto new_setting = new_spec.settings.find(key);
        if (old_setting != old_spec.settings.end() && new_setting != new_spec.settings.end() &&
            old_setting->second == new_setting->second)
            continue;
        const SettingInfo* info = kind ? find_setting(*kind, key) : nullptr;
        Change change{{},
                      fmt::format("Signal: {}", info ? info->label : key),
                      text_of(old_spec, key),
                      text_of(new_spec, key),
                      info ? info->unit : ""};
        if (change.before == change.after)
            change.after = "another value";  // long texts with the same beginning
        changes.push_back(std::move(change));
    }
}

std::string source_text(const std::string& source) {
    if (source.empty())
        return "none";
    return source.starts_with("pattern:") || is_live(source)
               ? source
               : std::filesystem::path(source).filename().string();
}

std::string override_text(const PassOverrides& overrides, const std::string& pass) {
    const auto found = overrides.find(pass);
    if (found == overrides.end())
        return "default";
    std::vector<std::string> parts;
    if (found->second.format)
        parts.emplace_back(info_of(*found->second.format).name);
    if (found->second.scale)
        parts.push_back(format_number(*found->second.scale) + "×");
    if (found->second.filter)
        parts.emplace_back(*found->second.filter == Filter::nearest ? "nearest" : "linear");
    return fmt::format("{}", fmt::join(parts, ", "));
}

void add_overrides(const PassOverrides& before, const PassOverrides& after,
                   std::vector<Change>& changes) {
    std::set<std::string> passes;
    for (const PassOverrides* overrides : {&before, &after})
        for (const auto& [pass, override] : *overrides)
            passes.insert(pass);
    for (const std::string& pass : passes) {
        std::string old_text = override_text(before, pass);
        std::string new_text = override_text(after, pass);
        if (old_text != new_text)
            changes.push_back(
                {{}, fmt::format("Pass {}", pass), std::move(old_text), std::move(new_text), {}});
    }
}

std::string tempo_text(const Tempo& tempo) {
    return fmt::format("{} BPM, downbeat at {} s, {} beats per bar", format_number(tempo.bpm),
                       format_number(tempo.downbeat), format_number(tempo.beats_per_bar));
}

std::string cues_text(const CueText& cues) {
    if (cues.is_empty())
        return "none";
    const auto lines = std::ranges::count(cues.text, '\n');
    return fmt::format("{}, {} line{}", std::filesystem::path(cues.file).filename().string(), lines,
                       lines == 1 ? "" : "s");
}

std::string stack_text(const Stack& stack) {
    std::string text;
    const std::vector<std::string> keys = stack_keys(stack);
    for (std::size_t i = 0; i < stack.size(); ++i)
        text += (i > 0 ? " + " : "") + (stack[i].is_bypassed ? "(" + keys[i] + ")" : keys[i]);
    return text;
}

std::string driver_text(const DocumentState& state) {
    return is_picture_driven(state.stack) ? "source picture" : "signal";
}
}  // namespace

std::vector<Change> changes_between(const Look& look, const DocumentState& before,
                                    const DocumentState& after) {
    std::vector<Change> changes;
    add_values(look, moved(before.values, before.stack, look.stack),
               moved(after.values, after.stack, look.stack), changes);
    add_modulations(look, moved(before.modulations, before.stack, look.stack),
                    moved(after.modulations, after.stack, look.stack), changes);
    if (before.tempo != after.tempo)
        changes.push_back({{}, "Tempo", tempo_text(before.tempo), tempo_text(after.tempo), {}});
    if (before.cues != after.cues)
        changes.push_back({{}, "Cues", cues_text(before.cues), cues_text(after.cues), {}});
    if (is_picture_driven(before.stack) != is_picture_driven(after.stack))
        changes.push_back({{}, "Driven by", driver_text(before), driver_text(after), {}});
    add_signal(before.signal, after.signal, changes);
    if (before.source != after.source)
        changes.push_back(
            {{}, "Source", source_text(before.source), source_text(after.source), {}});
    if (stack_text(before.stack) != stack_text(after.stack))
        changes.push_back({{}, "Stack", stack_text(before.stack), stack_text(after.stack), {}});
    add_overrides(moved(before.overrides, before.stack, after.stack), after.overrides, changes);
    return changes;
}

namespace {
std::string values_of(const Change& change) {
    const bool is_close = change.unit.empty() || change.unit == "°";
    return fmt::format("{} → {}{}{}", change.before, change.after, is_close ? "" : " ",
                       change.unit);
}
}  // namespace

std::string line_of(const Change& change) {
    return change.label + ' ' + values_of(change);
}

std::string summary_of(const std::vector<Change>& changes, const std::string& step) {
    if (changes.empty())
        return {};
    const Change& first = changes.front();
    const bool is_named = changes.size() == 1 && step.ends_with(first.label);
    const std::string text = is_named ? values_of(first) : line_of(first);
    return changes.size() == 1 ? text : fmt::format("{}, {} more", text, changes.size() - 1);
}
