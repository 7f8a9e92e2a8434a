#include "lab/document/users_content.h"

#include "formats/look_format.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"
#include "signals/signal_table.h"

#include <algorithm>
#include <filesystem>

namespace {
bool is_text(const SettingInfo& setting) {
    return setting.type == SettingType::text;
}

// The settings that identify the content: a file, a socket's path, strokes, a text.
std::vector<std::string> texts_of(const Spec& complete) {
    std::vector<std::string> texts;
    if (const SignalKind* kind = find_kind(complete.kind))
        for (const SettingInfo& setting : kind->settings)
            if (is_text(setting))
                texts.push_back(std::get<std::string>(complete.settings.at(setting.key)));
    return texts;
}

std::string file_name(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

std::string signal_name(const Spec& signal) {
    const SignalKind* kind = find_kind(signal.kind);
    const auto complete = completed(signal);
    if (!kind || !complete)
        return signal.kind;
    if (const std::string file = file_of(*complete); !file.empty())
        return file_name(file);
    return kind->label;
}

std::string source_name(const std::string& text) {
    const auto source = parse_source(text);
    if (!source)
        return text;
    if (source->is_live())
        return source->picture;
    if (!source->is_pattern())
        return file_name(source->picture);
    const std::string name = name_of_pattern(*source);
    const auto& patterns = all_patterns();
    const auto found = std::ranges::find(patterns, name, &PatternInfo::name);
    return found == patterns.end() ? name : found->label;
}
}  // namespace

bool is_users_content(const Spec& signal) {
    const SignalKind* kind = find_kind(signal.kind);
    return kind && (kind->is_live || kind->is_sent || std::ranges::any_of(kind->settings, is_text));
}

bool is_users_content(const std::string& source) {
    const auto spec = parse_source(source);
    return spec && !spec->picture.empty() && !spec->is_pattern();
}

bool is_same_content(const Spec& one, const Spec& other) {
    const auto first = completed(one);
    const auto second = completed(other);
    if (one.kind != other.kind || !first || !second)
        return one == other;
    return texts_of(*first) == texts_of(*second);
}

bool is_same_content(const std::string& one, const std::string& other) {
    const auto first = parse_source(one);
    const auto second = parse_source(other);
    return first && second ? first->picture == second->picture : one == other;
}

namespace {
constexpr const char* fit_key = "fit";
}  // namespace

Spec with_round_circles(Spec signal) {
    const SignalKind* kind = find_kind(signal.kind);
    const SettingInfo* fit = kind ? find_setting(*kind, fit_key) : nullptr;
    const auto complete = completed(signal);
    if (fit && complete && is_users_content(signal) && is_used(*fit, *complete) &&
        !signal.settings.contains(fit_key))
        signal.settings[fit_key] = std::string("whole");
    return signal;
}

std::string with_users_defaults(const std::string& source, const Look& look) {
    const bool is_foreign =
        is_foreign_look(look.stack.empty() ? look.manifest : look.stack.front().path);
    SourceSpec usual;
    usual.fit = is_foreign ? Fit::stretch : Fit::whole;
    usual.prescaled = 0;
    const auto spec = parse_source(source, usual);
    return spec && is_users_content(source) ? to_string(*spec) : source;
}

std::optional<Fit> beam_fit_of(const Spec& signal) {
    const SignalKind* kind = find_kind(signal.kind);
    const SettingInfo* fit = kind ? find_setting(*kind, fit_key) : nullptr;
    const auto complete = completed(signal);
    if (!fit || !complete || !is_used(*fit, *complete))
        return std::nullopt;
    return find_fit(std::get<std::string>(complete->settings.at(fit_key)));
}

std::string content_name(const Content& content, Driver driver) {
    return driver == Driver::picture ? source_name(content.source) : signal_name(content.signal);
}

std::string keep_content_label(Driver driver) {
    return driver == Driver::picture ? "Keep my source" : "Keep my signal";
}

std::string use_content_label(Driver driver) {
    return driver == Driver::picture ? "Use the preset's source" : "Use the preset's signal";
}

bool is_locked_in(Driver driver, const ContentLocks& locks) {
    return (driver == Driver::signal && locks.signal) ||
           (driver == Driver::picture && locks.source);
}
