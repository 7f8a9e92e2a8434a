#include "formats/json/spec_json.h"

#include "formats/json/json_text.h"
#include "signals/signal_table.h"

#include <nlohmann/json.hpp>

std::optional<Spec> read_spec(const JsonValue& value, const std::filesystem::path& file,
                              Diagnostics& problems) {
    const std::size_t before = problems.size();
    ObjectReader reader(value, file, problems);
    reader.require("kind");
    Spec spec{reader.text("kind"), {}};
    for (const JsonValue& member : value.children) {
        if (member.key == "kind" || !value.is(JsonValue::Kind::object))
            continue;
        if (member.is(JsonValue::Kind::number))
            spec.settings[member.key] = member.number;
        else if (reader.expect(member, JsonValue::Kind::text))
            spec.settings[member.key] = member.text;
    }
    if (problems.size() > before)
        return std::nullopt;
    if (const auto checked = completed(spec); !checked) {
        for (const Diagnostic& reason : checked.error())
            reader.problem(value, reason.message);
        return std::nullopt;
    }
    return spec;
}

nlohmann::ordered_json json_of(const Spec& spec) {
    nlohmann::ordered_json json{{"kind", spec.kind}};
    const SignalKind* kind = find_kind(spec.kind);
    for (const auto& [key, setting] : spec.settings) {
        const std::string& name = key.empty() && kind ? kind->bare_setting : key;
        std::visit([&](const auto& plain) { json[name] = plain; }, setting);
    }
    return json;
}
