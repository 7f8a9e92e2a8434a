#include "formats/preset/preset_format.h"

#include "base/file.h"
#include "formats/json/json_text.h"
#include "formats/json/spec_json.h"
#include "formats/json/value_json.h"
#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_png.h"
#include "formats/preset/preset_update.h"
#include "formats/preset/share_line.h"
#include "io/files/atomic_file.h"
#include "io/pictures/png_chunks.h"
#include "model/look/stack_size.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using Json = nlohmann::ordered_json;

namespace {
constexpr FileFormat preset_file{"afterglow-preset", 1};
constexpr std::size_t max_values = 65'536;  // four times the parameters of the largest look

Values read_values(ObjectReader& reader) {
    Values values;
    const JsonValue* member = reader.find("values");
    if (!member || !reader.expect(*member, JsonValue::Kind::object))
        return values;
    if (member->children.size() > max_values) {
        reader.problem(*member, fmt::format("the preset has {} values; the limit is {}",
                                            member->children.size(), max_values));
        return values;
    }
    for (const JsonValue& child : member->children)
        if (auto value = read_value(child, reader))
            values[child.key] = std::move(*value);
    return values;
}

// The bypassed looks of a stack, by key.
std::vector<std::string> read_bypass(ObjectReader& reader, const std::string& look) {
    std::vector<std::string> bypass;
    const JsonValue* list = reader.find("bypass");
    if (!list || !reader.expect(*list, JsonValue::Kind::array))
        return bypass;
    const std::vector<std::string> keys = stack_keys(look_ids(look));
    if (list->children.size() > keys.size()) {
        reader.problem(*list, fmt::format("'bypass' lists {} looks, but the stack has only {}",
                                          list->children.size(), keys.size()));
        return bypass;
    }
    for (const JsonValue& item : list->children) {
        if (!reader.expect(item, JsonValue::Kind::text))
            continue;
        if (std::ranges::find(keys, item.text) == keys.end())
            reader.problem(
                item, fmt::format("unknown look '{}' in '{}'{}; use one of: {}", item.text, look,
                                  did_you_mean(item.text, keys), fmt::join(keys, ", ")));
        bypass.push_back(item.text);
    }
    return bypass;
}

Result<Value> fitted_value(const Parameter& parameter, const Value& value) {
    const bool takes_path =
        parameter.control == Control::image || parameter.control == Control::sound;
    if (takes_path && !value.numbers.empty())
        return fail(
            {{}, 0, fmt::format("'{}' must be the path of a file, got numbers", parameter.name)});
    if (takes_path)
        return value;
    if (value.numbers.empty())
        return parse_value(parameter, value.path);
    const auto size = static_cast<std::size_t>(parameter.type.size());
    if (value.numbers.size() != size)
        return fail({{}, 0, wrong_count(parameter.name, size, value.numbers.size())});
    return clamped(parameter, value);
}
}  // namespace

Result<Preset> parse_preset(std::string_view text, const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    if (!accept_header(reader, preset_file))
        return fail(std::move(problems));
    Preset preset;
    const JsonValue* look = reader.require("look");
    preset.look = reader.text("look");
    if (look && look->is(JsonValue::Kind::text) && look->text.empty())
        reader.problem(*look, "'look' is empty; set it to the name of a look");
    if (const std::string fault = fault_of_stack_size(preset.look); look && !fault.empty()) {
        reader.problem(*look, fault);
        return fail(std::move(problems));
    }
    preset.digest = reader.text("look_digest");
    preset.name = reader.text("name");
    preset.about = reader.text("about");
    preset.author = reader.text("author");
    if (const JsonValue* signal = reader.find("signal"))
        preset.signal = read_spec(*signal, file, problems);
    preset.source = reader.text("source");
    preset.media_digest = reader.text("media_digest");
    preset.bypass = read_bypass(reader, preset.look);
    preset.values = read_values(reader);
    preset.modulations = read_modulations(reader);
    if (reader.find("tempo"))
        preset.tempo = read_tempo(reader);
    reader.report_unknown_keys();
    if (!problems.empty())
        return fail(std::move(problems));
    return preset;
}

Result<Preset> load_preset(const std::filesystem::path& file) {
    const auto start = read_start(file, png_signature().size());
    if (!start)
        return fail(start.error());
    if (is_png(*start)) {
        const auto bytes = read_bytes(file);
        return bytes ? preset_from_png(*bytes, file) : fail(bytes.error());
    }
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    if (!is_share_line(*text))
        return parse_preset(*text, file);
    auto preset = parse_share_line(*text);
    if (!preset)
        for (Diagnostic& reason : preset.error())
            reason.file = file;
    return preset;
}

nlohmann::ordered_json preset_json(const Preset& preset, const Look* look, Digits digits) {
    Json json{{"format", preset_file.name}, {"version", preset_file.newest_version},
              {"look", preset.look},        {"look_digest", preset.digest},
              {"name", preset.name},        {"about", preset.about},
              {"author", preset.author}};
    if (preset.signal)
        json["signal"] = json_of(*preset.signal);
    if (!preset.source.empty())
        json["source"] = preset.source;
    if (!preset.media_digest.empty())
        json["media_digest"] = preset.media_digest;
    if (!preset.bypass.empty())
        json["bypass"] = preset.bypass;
    json["values"] = Json::object();
    for (const auto& [name, value] : preset.values)
        json["values"][name] = json_of(value, look ? find_parameter(*look, name) : nullptr);
    if (preset.tempo)
        json["tempo"] = json_of(*preset.tempo);
    if (!preset.modulations.empty())
        json["modulation"] = json_of(preset.modulations);
    return digits == Digits::all ? json : with_float_digits(std::move(json));
}

std::string preset_to_json(const Preset& preset, const Look* look) {
    return json_text(preset_json(preset, look));
}

Result<void> save_preset(const std::filesystem::path& file, const Preset& preset,
                         const Look* look) {
    std::error_code error;
    const auto current = std::filesystem::is_regular_file(file, error)
                             ? read_text(file)
                             : Result<std::string>(fail(Diagnostics()));
    return write_atomically(
        file, current ? updated_preset_text(*current, preset, look) : preset_to_json(preset, look));
}

bool is_written_alike(const Preset& one, const Preset& other, const Look& look) {
    const auto written = [&look](Preset preset) {
        if (auto fitted = fitted_values(look, preset, {}))
            preset.values = std::move(*fitted);
        return preset_json(preset, &look);
    };
    return written(one) == written(other);
}

Preset with_all_values(Preset preset, const Look& look) {
    preset.values = renamed_values(look, std::move(preset.values));
    for (const Parameter& parameter : look.parameters)
        preset.values.try_emplace(parameter.name, parameter.initial);
    return preset;
}

Result<Values> fitted_values(const Look& look, const Preset& preset,
                             const std::filesystem::path& file) {
    Diagnostics problems;
    std::optional<std::map<std::string, int>> lines;  // read once, on the first error
    Values values = renamed_values(look, preset.values);
    for (auto& [name, value] : values) {
        const Parameter* parameter = find_parameter(look, name);
        if (!parameter)
            continue;
        auto fitted = fitted_value(*parameter, value);
        if (fitted) {
            value = std::move(*fitted);
            continue;
        }
        if (!lines)
            lines = member_lines(file, "values");
        const auto line = lines->find(preset.values.contains(name) ? name : parameter->was);
        problems.push_back(
            {file, line == lines->end() ? 0 : line->second, fitted.error().front().message});
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return values;
}
