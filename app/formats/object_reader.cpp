#include "formats/object_reader.h"

#include <algorithm>
#include <cmath>

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
        problem(m_object, fmt::format("\"{}\" is missing", key));
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
    problem(*value, fmt::format("\"{}\" must be a whole number from {} to {}", key, low, high));
    return fallback;
}

void ObjectReader::refuse_unknown() {
    if (!m_object.is(JsonValue::Kind::object))
        return;
    for (const JsonValue& member : m_object.children)
        if (std::find(m_known.begin(), m_known.end(), member.key) == m_known.end())
            problem(member, fmt::format("unknown key \"{}\"{}", member.key,
                                        did_you_mean(member.key, m_known)));
}

void ObjectReader::problem(const JsonValue& value, std::string message) {
    m_problems.push_back({m_file, value.line, std::move(message)});
}

bool ObjectReader::expect(const JsonValue& value, JsonValue::Kind kind) {
    if (value.is(kind))
        return true;
    const std::string name = value.key.empty() ? "this" : '"' + value.key + '"';
    problem(value,
            fmt::format("{} must be {}, not {}", name, kind_name(kind), kind_name(value.kind)));
    return false;
}

void ObjectReader::refuse_choice(const JsonValue& value, const std::vector<std::string>& names) {
    problem(value, fmt::format("\"{}\" cannot be '{}'{}; it is one of: {}", value.key, value.text,
                               did_you_mean(value.text, names), fmt::join(names, ", ")));
}

bool accept_header(ObjectReader& reader, const FileFormat& file_format) {
    if (!reader.object().is(JsonValue::Kind::object))
        return false;
    const std::size_t before = reader.problems().size();
    const JsonValue* name = reader.require("format");
    if (name && reader.expect(*name, JsonValue::Kind::text) && name->text != file_format.name)
        reader.problem(*name, fmt::format("\"format\" must be \"{}\", not \"{}\"", file_format.name,
                                          name->text));
    const JsonValue* version = reader.require("version");
    constexpr int any = 1000000;
    const int number = reader.whole("version", 0, 1, any);
    if (number > file_format.newest_version)
        reader.problem(*version,
                       fmt::format("was written by a newer version of the program: version "
                                   "{} of its format, {} is the newest that is read",
                                   number, file_format.newest_version));
    return reader.problems().size() == before;
}
