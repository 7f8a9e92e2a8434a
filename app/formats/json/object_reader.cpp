#include "formats/json/object_reader.h"

#include <algorithm>
#include <cmath>

namespace {
// The message for a member of the wrong kind: {0} is its key, {1} its value.
std::string_view refusal_of_member(JsonValue::Kind kind) {
    switch (kind) {
        case JsonValue::Kind::boolean:
            return "'{0}' must be true or false, got {1}";
        case JsonValue::Kind::number:
            return "'{0}' must be a number, got {1}";
        case JsonValue::Kind::text:
            return "'{0}' must be a text in quotes, got {1}";
        case JsonValue::Kind::array:
            return "'{0}' must be a list [...], got {1}";
        case JsonValue::Kind::object:
            return "'{0}' must be an object {{...}}, got {1}";
        case JsonValue::Kind::null:
            break;
    }
    return "'{0}' must be null, got {1}";
}

// For a whole document or a list element: {1} is its value.
std::string_view refusal_of_element(JsonValue::Kind kind) {
    switch (kind) {
        case JsonValue::Kind::boolean:
            return "expected true or false, got {1}";
        case JsonValue::Kind::number:
            return "expected a number, got {1}";
        case JsonValue::Kind::text:
            return "expected a text in quotes, got {1}";
        case JsonValue::Kind::array:
            return "expected a list [...], got {1}";
        case JsonValue::Kind::object:
            return "expected an object {{...}}, got {1}";
        case JsonValue::Kind::null:
            break;
    }
    return "expected null, got {1}";
}
}  // namespace

ObjectReader::ObjectReader(const JsonValue& value, const std::filesystem::path& file,
                           Diagnostics& problems)
    : m_object(value), m_file(file), m_problems(problems) {
    expect(value, JsonValue::Kind::object);
}

const JsonValue* ObjectReader::find(std::string_view key) {
    m_known.emplace_back(key);
    return find_member(m_object, key);
}

const JsonValue* ObjectReader::require(std::string_view key) {
    const JsonValue* value = find(key);
    if (!value && m_object.is(JsonValue::Kind::object))
        problem(m_object, fmt::format("'{}' is missing", key));
    return value;
}

std::string ObjectReader::text(std::string_view key, const std::string& fallback) {
    const JsonValue* value = find(key);
    return value && expect(*value, JsonValue::Kind::text) ? value->text : fallback;
}

bool ObjectReader::boolean(std::string_view key, bool fallback) {
    const JsonValue* value = find(key);
    return value && expect(*value, JsonValue::Kind::boolean) ? value->boolean : fallback;
}

double ObjectReader::number(std::string_view key, double fallback) {
    const JsonValue* value = find(key);
    return value && expect(*value, JsonValue::Kind::number) ? value->number : fallback;
}

int ObjectReader::whole(std::string_view key, int fallback, int low, int high) {
    const JsonValue* value = find(key);
    if (!value || !expect(*value, JsonValue::Kind::number))
        return fallback;
    if (value->number == std::floor(value->number) && value->number >= low && value->number <= high)
        return static_cast<int>(value->number);
    problem(*value, fmt::format("'{}' must be a whole number between {} and {}, got {}", key, low,
                                high, format_number(value->number)));
    return fallback;
}

void ObjectReader::report_unknown_keys() {
    if (!m_object.is(JsonValue::Kind::object))
        return;
    for (const JsonValue& member : m_object.children)
        if (std::find(m_known.begin(), m_known.end(), member.key) == m_known.end())
            problem(member, fmt::format("unknown key '{}'{}", member.key,
                                        did_you_mean(member.key, m_known)));
}

void ObjectReader::problem(const JsonValue& value, std::string message) {
    m_problems.push_back({m_file, value.line, std::move(message)});
}

bool ObjectReader::expect(const JsonValue& value, JsonValue::Kind kind) {
    if (value.is(kind))
        return true;
    const std::string_view words =
        value.key.empty() ? refusal_of_element(kind) : refusal_of_member(kind);
    problem(value, fmt::format(fmt::runtime(words), value.key, shown_json(value)));
    return false;
}

void ObjectReader::refuse_choice(const JsonValue& value, const std::vector<std::string>& names) {
    problem(value, fmt::format("unknown value '{}' for '{}'{}; use one of: {}", value.text,
                               value.key, did_you_mean(value.text, names), fmt::join(names, ", ")));
}

bool accept_header(ObjectReader& reader, const FileFormat& file_format) {
    if (!reader.object().is(JsonValue::Kind::object))
        return false;
    const std::size_t before = reader.problems().size();
    const JsonValue* name = reader.require("format");
    if (name && reader.expect(*name, JsonValue::Kind::text) && name->text != file_format.name)
        reader.problem(
            *name, fmt::format("'format' must be '{}', got '{}'", file_format.name, name->text));
    const JsonValue* version = reader.require("version");
    constexpr int any = 1000000;
    const int number = reader.whole("version", 0, 1, any);
    if (number > file_format.newest_version)
        reader.problem(*version,
                       fmt::format("format version {} is too new; this version of Afterglow "
                                   "reads up to {}. Update Afterglow to open it.",
                                   number, file_format.newest_version));
    return reader.problems().size() == before;
}
