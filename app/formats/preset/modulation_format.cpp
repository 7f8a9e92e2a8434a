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
    for (const ModulationFigure& figure : figures_of(modulation.kind))
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

Json json_of(const Modulation& modulation) {
    Json json{{"kind", key_of(modulation_kinds(), modulation.kind)}};
    if (modulation.kind == ModulationKind::lfo)
        json["shape"] = key_of(lfo_shapes(), modulation.shape);
    for (const ModulationFigure& figure : figures_of(modulation.kind))
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
