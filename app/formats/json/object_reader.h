#pragma once

#include "base/text.h"
#include "formats/json/json_document.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A named choice of a key's value.
template <class T>
using Choices = std::vector<std::pair<std::string_view, T>>;

/// Reads an object member by member and notes every mistake at its line; what is wrong or not there
/// reads as the fallback. At the end refuse_unknown() notes each key that was never asked for.
class ObjectReader {
public:
    /// Notes a mistake when `value` is no object, and then has no members. Keeps references.
    ObjectReader(const JsonValue& value, const std::filesystem::path& file, Diagnostics& problems);

    /// The member, or null; its key counts as known.
    const JsonValue* find(std::string_view key);
    /// As find(), but notes when it is not there.
    const JsonValue* require(std::string_view key);

    std::string text(std::string_view key, const std::string& fallback = {});
    bool boolean(std::string_view key, bool fallback);
    double number(std::string_view key, double fallback);
    /// A whole number from `low` to `high`.
    int whole(std::string_view key, int fallback, int low, int high);

    template <class T>
    T choice(std::string_view key, const Choices<T>& choices, T fallback) {
        const JsonValue* value = find(key);
        if (!value || !expect(*value, JsonValue::Kind::text))
            return fallback;
        std::vector<std::string> names;
        for (const auto& [name, chosen] : choices) {
            if (name == value->text)
                return chosen;
            names.emplace_back(name);
        }
        refuse_choice(*value, names);
        return fallback;
    }

    /// Notes each key that was not asked for, with the nearest one that is known.
    void refuse_unknown();

    /// Notes a mistake at `value`'s line.
    void problem(const JsonValue& value, std::string message);
    /// Whether the value is of that kind; notes when it is not.
    bool expect(const JsonValue& value, JsonValue::Kind kind);
    const JsonValue& object() const { return m_object; }
    const std::filesystem::path& file() const { return m_file; }
    Diagnostics& problems() { return m_problems; }

private:
    void refuse_choice(const JsonValue& value, const std::vector<std::string>& names);

    const JsonValue& m_object;
    const std::filesystem::path& m_file;
    Diagnostics& m_problems;
    std::vector<std::string> m_known;
};

/// What every document of ours starts with, as "format" and "version".
struct FileFormat {
    std::string_view name;
    int newest_version = 1;
};

/// Reads the "format" and "version" of a document. False, and noted, where it is of another format
/// or newer than ours; then nothing else of it should be read.
bool accept_header(ObjectReader& reader, const FileFormat& file_format);
