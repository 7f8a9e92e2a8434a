#include "formats/preset/modulation_format.h"

#include "formats/json/json_text.h"
#include "model/look/renamed.h"

#include <nlohmann/json.hpp>

using Json = nlohmann::ordered_json;

namespace {
template <class T>
Choices<T> choices(const std::vector<ModulationName<T>>& words) {
    Choices<T> choices;
    for (const ModulationName<T>& word : words)
        choices.emplace_back(word.key, word.value);
    return choices;
}

template <class T>
const std::string& key_of(const std::vector<ModulationName<T>>& words, T value) {
    return std::ranges::find(words, value, &ModulationName<T>::value)->key;
}

void read_figure(ObjectReader& reader, const ModulationFigure& figure, Modulation& modulation) {
    const JsonValue* value = reader.find(figure.key);
    if (!value || !reader.expect(*value, JsonValue::Kind::number))
        return;
    if (value->number < figure.limit.low || value->number > figure.limit.high)
        reader.problem(
            *value, fmt::format("'{}' must be between {} and {}, got {}", figure.key,
                                format_number(figure.limit.low), format_number(figure.limit.high),
                                format_number(value->number)));
    modulation.*figure.number = value->number;
}

Modulation read_modulation(const JsonValue& value, ObjectReader& parent) {
    ObjectReader reader(value, parent.file(), parent.problems());
    Modulation modulation;
    if (!value.is(JsonValue::Kind::object))
        return modulation;
    reader.require("kind");
    modulation.kind = reader.choice("kind", choices(modulation_kinds()), modulation.kind);
    if (modulation.kind == ModulationKind::lfo)
        modulation.shape = reader.choice("shape", choices(lfo_shapes()), modulation.shape);
    modulation.is_in_beats =
        reader.choice("unit", Choices<bool>{{"seconds", false}, {"beats", true}}, false);
    for (const ModulationFigure& figure : figures_of(modulation))
        read_figure(reader, figure, modulation);
    reader.report_unknown_keys();
    return modulation;
}
}  // namespace

Modulations read_modulations(ObjectReader& reader) {
    Modulations modulations;
    const JsonValue* member = reader.find("modulation");
    if (!member || !reader.expect(*member, JsonValue::Kind::object))
        return modulations;
    for (const JsonValue& child : member->children)
        modulations[child.key] = read_modulation(child, reader);
    return modulations;
}

Tempo read_tempo(ObjectReader& parent) {
    const JsonValue* member = parent.find("tempo");
    if (!member)
        return {};
    ObjectReader reader(*member, parent.file(), parent.problems());
    Tempo tempo;
    tempo.bpm = reader.number("bpm", tempo.bpm);
    if (!(tempo.bpm >= min_bpm && tempo.bpm <= max_bpm))
        reader.problem(
            *member, fmt::format("'bpm' must be between {} and {}, got {}", format_number(min_bpm),
                                 format_number(max_bpm), format_number(tempo.bpm)));
    tempo.downbeat = reader.number("downbeat", tempo.downbeat);
    constexpr int most = static_cast<int>(max_beats_per_bar);
    tempo.beats_per_bar = reader.whole("beats_per_bar", 4, 1, most);
    reader.report_unknown_keys();
    return normalised(tempo);
}

Json json_of(const Tempo& tempo) {
    Json json{{"bpm", tempo.bpm}};
    if (tempo.downbeat != Tempo{}.downbeat)
        json["downbeat"] = tempo.downbeat;
    if (tempo.beats_per_bar != Tempo{}.beats_per_bar)
        json["beats_per_bar"] = static_cast<int>(tempo.beats_per_bar);
    return json;
}

Json json_of(const Modulation& modulation) {
    Json json{{"kind", key_of(modulation_kinds(), modulation.kind)}};
    if (modulation.kind == ModulationKind::lfo)
        json["shape"] = key_of(lfo_shapes(), modulation.shape);
    if (modulation.is_in_beats)
        json["unit"] = "beats";
    for (const ModulationFigure& figure : figures_of(modulation))
        json[figure.key] = modulation.*figure.number;
    return json;
}

Json json_of(const Modulations& modulations) {
    Json json = Json::object();
    for (const auto& [name, modulation] : modulations)
        json[name] = json_of(modulation);
    return json;
}

Result<Modulations> fitted_modulations(const Look& look, const Preset& preset,
                                       const std::filesystem::path& file) {
    Diagnostics problems;
    std::optional<std::map<std::string, int>> lines;  // read once, on the first error
    Modulations modulations = renamed(look, preset.modulations);
    for (const auto& [name, modulation] : modulations) {
        const Parameter* parameter = find_parameter(look, name);
        const std::string reason = parameter ? why_unmodulated(look, *parameter) : std::string();
        if (reason.empty())
            continue;
        if (!lines)
            lines = member_lines(file, "modulation");
        const auto line = lines->find(preset.modulations.contains(name) ? name : parameter->was);
        problems.push_back({file, line == lines->end() ? 0 : line->second, reason});
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return modulations;
}
