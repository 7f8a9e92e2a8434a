#include "signals/signal/signal_kind.h"

#include "signals/signal/settings.h"

#include <algorithm>

const SettingInfo* find_setting(const SignalKind& kind, std::string_view key) {
    const auto found = std::find_if(kind.settings.begin(), kind.settings.end(),
                                    [&](const SettingInfo& known) { return known.key == key; });
    return found == kind.settings.end() ? nullptr : &*found;
}

bool is_used(const SettingInfo& setting, const Spec& completed_spec) {
    const SettingCondition& condition = setting.condition;
    if (condition.key.empty())
        return true;
    const std::string_view word = Settings(completed_spec).word(condition.key);
    return std::find(condition.words.begin(), condition.words.end(), word) != condition.words.end();
}

SettingInfo choice_setting(std::string key, std::string label, std::string help,
                           std::vector<std::string> words) {
    const std::string first = words.front();
    return {.key = std::move(key),
            .label = std::move(label),
            .help = std::move(help),
            .type = SettingType::word,
            .words = std::move(words),
            .initial_word = first};
}

SettingInfo fit_setting(SettingCondition condition) {
    SettingInfo fit = choice_setting(
        "fit", "Fit",
        "whole: fits the picture, circles stay round. stretch: fills the picture, circles may "
        "become ellipses. crop: fills the picture, circles stay round and edges are cut off. look: "
        "uses the look's own Fit setting.",
        {"look", "whole", "stretch", "crop"});
    fit.condition = std::move(condition);
    return fit;
}

std::vector<SettingInfo> in_group(const std::string& group, const SettingCondition& condition,
                                  std::vector<SettingInfo> settings) {
    for (SettingInfo& setting : settings) {
        setting.group = group;
        if (setting.condition.key.empty())
            setting.condition = condition;
    }
    return settings;
}
