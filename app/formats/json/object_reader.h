#pragma once

#include "base/text.h"
#include "formats/json/json_document.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Named choices of a key's value.
template <class T>
using Choices = std::vector<std::pair<std::string_view, T>>;

/// Reads an object by member and reports each error with its line. An invalid or missing member
/// reads as the fallback. At the end, report_unknown_keys() reports each key that was not read.
class ObjectReader {
public:
    /// Reports an error if `value` is not an object, and then has no members. Keeps references.
    ObjectReader(const JsonValue& value, const std::filesystem::path& file, Diagnostics& problems);

    /// The member, or null. Marks its key as known.
    const JsonValue* find(std::string_view key);
    /// Like find(), but reports a missing member.
    const JsonValue* require(std::string_view key);

    std::string text(std::string_view key, const std::string& fallback = {});
    bool boolean(std::string_view key, bool fallback);
    double number(std::string_view key, double fallback);
    /// An integer from `low` to `high`.
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

    /// Reports each unknown key, with the most similar known key.
    void report_unknown_keys();

    /// Reports an error at `value`'s line.
    void problem(const JsonValue& value, std::string message);
    /// Whether the value is of that kind; reports an error if not.
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

/// The "format" and "version" at the start of each Afterglow document.
struct FileFormat {
    std::string_view name;
    int newest_version = 1;
};

/// Checks the "format" and "version" of a document. False, with an error, for another format or a
/// newer version; then do not read the rest.
bool accept_header(ObjectReader& reader, const FileFormat& file_format);
