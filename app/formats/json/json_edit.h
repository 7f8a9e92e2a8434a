#pragma once

#include "formats/json/json_document.h"

#include <string>
#include <string_view>
#include <vector>

/// Changes of a JSON text that keep all other bytes. All positions refer to the original text. The
/// text must outlive the edit.
class JsonEdit {
public:
    explicit JsonEdit(std::string_view text) : m_text(text) {}

    /// Replaces bytes [begin, end).
    void replace(std::size_t begin, std::size_t end, std::string text) {
        m_changes.push_back({begin, end, std::move(text)});
    }
    /// Sets a member of an object to a value in JSON. A new member is appended, with the separator
    /// used before it.
    void set(const JsonValue& object, std::string_view key, const std::string& value);
    /// Inserts a value in JSON after an element of an array, with the separator used there.
    void insert_after(const JsonValue& array, std::size_t element, const std::string& value);
    /// Removes an element of an array that has others.
    void remove(const JsonValue& array, std::size_t element);
    /// Exchanges an element of an array with the next one.
    void swap_with_next(const JsonValue& array, std::size_t element);

    /// The text of a value before the edit.
    std::string written(const JsonValue& value) const {
        return std::string(m_text.substr(value.begin, value.end - value.begin));
    }
    /// The text with all changes.
    std::string edited();

private:
    struct Change {
        std::size_t begin;
        std::size_t end;
        std::string text;
    };

    std::string between(std::size_t begin, std::size_t end) const {
        return std::string(m_text.substr(begin, end - begin));
    }
    std::string separator_of(const JsonValue& object) const;

    std::string_view m_text;
    std::vector<Change> m_changes;
};

/// A word without special characters as a JSON string.
std::string json_word(std::string_view word);
