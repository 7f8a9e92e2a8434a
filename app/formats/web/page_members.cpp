#include "formats/web/page_members.h"

#include "model/look/stack.h"
#include "signals/signal_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

using Json = nlohmann::ordered_json;

namespace {
// Signals that a page can draw without files of the look. A user opens the sound.
constexpr std::array generator_names{"lissajous", "waveform", "harmonics", "am",
                                     "fm",        "audio",    "microphone"};

std::string condition_text(const SettingCondition& condition) {
    std::string text;
    for (const std::string& word : condition.words)
        text += fmt::format("{}{} == \"{}\"", text.empty() ? "" : " || ", condition.key, word);
    return text;
}

Json number_setting(const SettingInfo& setting) {
    return {{"type", setting.step == 1.0 ? "int" : "float"},
            {"default", setting.initial},
            {"min", setting.low},
            {"max", setting.high},
            {"step", setting.step},
            {"scale", setting.logarithmic ? "log" : "linear"},
            {"limit", {{"min", setting.limit.low}, {"max", setting.limit.high}}},
            {"items", Json::array()}};
}

Json word_setting(const SettingInfo& setting) {
    Json json{{"type", "list"}, {"default", setting.initial_word}, {"items", Json::array()}};
    for (std::size_t i = 0; i < setting.words.size(); ++i)
        json["items"].push_back({{"value", i}, {"label", setting.words[i]}});
    return json;
}

Json setting_json(const SettingInfo& setting) {
    Json json = setting.type == SettingType::word ? word_setting(setting) : number_setting(setting);
    json["name"] = setting.key;
    json["label"] = setting.label;
    json["unit"] = setting.unit;
    json["help"] = setting.help;
    json["group"] = setting.group;
    if (!setting.condition.key.empty())
        json["when"] = condition_text(setting.condition);
    return json;
}

Json generators_json() {
    Json json = Json::array();
    for (const char* const name : generator_names) {
        const SignalKind* kind = find_kind(name);
        Json settings = Json::array();
        for (const SettingInfo& setting : kind->settings)
            if (setting.type != SettingType::text && !setting.is_hidden)
                settings.push_back(setting_json(setting));
        json.push_back({{"kind", kind->kind}, {"label", kind->label}, {"settings", settings}});
    }
    return json;
}

void add_control(const Parameter& parameter, Json& json) {
    if (parameter.limit)
        json["limit"] = {{"min", parameter.limit->low}, {"max", parameter.limit->high}};
    if (!parameter.parts.empty())
        json["parts"] = parameter.parts;
    if (parameter.control == Control::angle)
        json["angle"] = true;
    if (parameter.is_hidden)
        json["hidden"] = true;
    if (!parameter.was.empty())
        json["was"] = parameter.was;
}
}  // namespace

void add_page_members(const Look& look, Json& json) {
    json["id"] = look.id;
    json["digest"] = look_digest(look);
    if (look.manifest.filename() != "look.json")
        json["foreign"] = true;
    if (look.driven_by == Driver::signal)
        json["generators"] = generators_json();
    for (std::size_t i = 0; i < look.parameters.size(); ++i)
        add_control(look.parameters[i], json["parameters"][i]);
}
