#include "signals/kinds.h"

#include "signals/audio.h"
#include "signals/drawn.h"
#include "signals/harmonics.h"
#include "signals/lissajous.h"
#include "signals/modulation.h"
#include "signals/sent.h"
#include "signals/settings.h"
#include "signals/stroke_font.h"
#include "signals/waveform.h"

#include <fmt/format.h>

#include <algorithm>

const std::vector<SignalKind>& signal_kinds() {
    static const std::vector<SignalKind> kinds{lissajous_kind(),  waveform_kind(), harmonics_kind(),
                                               am_kind(),         fm_kind(),       audio_kind(),
                                               microphone_kind(), scene_kind(),    text_kind(),
                                               drawing_kind(),    stdin_kind(),    socket_kind()};
    return kinds;
}

const SignalKind* find_kind(std::string_view kind) {
    const auto& kinds = signal_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const SignalKind& known) { return known.kind == kind; });
    return found == kinds.end() ? nullptr : &*found;
}

const SettingFacts* find_setting(const SignalKind& kind, std::string_view key) {
    const auto found = std::find_if(kind.settings.begin(), kind.settings.end(),
                                    [&](const SettingFacts& known) { return known.key == key; });
    return found == kind.settings.end() ? nullptr : &*found;
}

bool is_used(const SettingFacts& setting, const Spec& completed_spec) {
    const UsedWhile& condition = setting.used_while;
    if (condition.key.empty())
        return true;
    const std::string_view word = Settings(completed_spec).word(condition.key);
    return std::find(condition.words.begin(), condition.words.end(), word) != condition.words.end();
}

SettingFacts choice_setting(std::string key, std::string label, std::string help,
                            std::vector<std::string> words) {
    const std::string first = words.front();
    return {.key = std::move(key),
            .label = std::move(label),
            .help = std::move(help),
            .type = SettingType::word,
            .words = std::move(words),
            .initial_word = first};
}

SettingFacts fit_setting(UsedWhile used_while) {
    SettingFacts fit = choice_setting(
        "fit", "Fit",
        "whole: fits the picture, circles stay round. stretch: fills the picture, circles may "
        "become ellipses. crop: fills the picture, circles stay round and edges are cut off. look: "
        "uses the look's own Fit setting.",
        {"look", "whole", "stretch", "crop"});
    fit.used_while = std::move(used_while);
    return fit;
}

std::vector<SettingFacts> in_group(const std::string& group, const UsedWhile& used_while,
                                   std::vector<SettingFacts> settings) {
    for (SettingFacts& setting : settings) {
        setting.group = group;
        if (setting.used_while.key.empty())
            setting.used_while = used_while;
    }
    return settings;
}

Result<Spec> parse_signal(std::string_view text) {
    return parse_spec(text, [](std::string_view kind_name, std::string_view key) {
        const SignalKind* kind = find_kind(kind_name);
        return !kind || kind->bare_setting.empty() || find_setting(*kind, key) != nullptr;
    });
}

Diagnostics notes_about(const Spec& spec) {
    const auto complete = spec.kind == "text" ? completed(spec) : fail({{}, 0, ""});
    const std::string missing =
        complete ? missing_letters(Settings(*complete).word("text")) : std::string();
    if (missing.empty())
        return {};
    return {{{},
             0,
             fmt::format("text: characters missing from the font are drawn as boxes: {}", missing),
             Severity::warning}};
}

std::string file_of(const Spec& spec) {
    const SignalKind* kind = find_kind(spec.kind);
    if (!kind || kind->file_setting.empty())
        return {};
    const auto complete = completed(spec);
    return complete ? std::string(Settings(*complete).word(kind->file_setting)) : std::string();
}

Result<std::unique_ptr<Signal>> make_signal(const Spec& spec, const SignalMedia& media) {
    const auto complete = completed(spec);
    if (!complete)
        return fail(complete.error());
    return find_kind(complete->kind)->make(Settings(*complete), media);
}
