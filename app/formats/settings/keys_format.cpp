#include "formats/settings/keys_format.h"

#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"

#include <nlohmann/json.hpp>

namespace {
constexpr FileFormat keys_file{"afterglow-keys", 1};
}  // namespace

Result<std::vector<KeyChoice>> parse_keys(std::string_view text,
                                          const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    std::vector<KeyChoice> choices;
    if (accept_header(reader, keys_file)) {
        const JsonValue* keys = reader.find("keys");
        if (keys && reader.expect(*keys, JsonValue::Kind::object))
            for (const JsonValue& key : keys->children)
                if (reader.expect(key, JsonValue::Kind::text))
                    choices.push_back({key.key, key.text, key.line});
        reader.report_unknown_keys();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return choices;
}

std::string keys_to_json(const std::vector<KeyChoice>& choices) {
    nlohmann::ordered_json keys = nlohmann::ordered_json::object();
    for (const KeyChoice& choice : choices)
        keys[choice.action] = choice.key;
    return json_text({{"format", keys_file.name},
                      {"version", keys_file.newest_version},
                      {"keys", std::move(keys)}});
}
