#pragma once

#include "base/shared.h"

#include <ostream>
#include <string>
#include <string_view>

/// A long text passed by value: copy-on-write, and readable as a string.
class SharedText {
public:
    SharedText() = default;
    SharedText(std::string text) : m_text(std::move(text)) {}
    SharedText(const char* text) : m_text(text) {}

    operator const std::string&() const { return *m_text; }
    operator std::string_view() const { return *m_text; }
    const std::string& operator*() const { return *m_text; }
    const std::string* operator->() const { return &*m_text; }
    bool empty() const { return m_text->empty(); }
    std::size_t size() const { return m_text->size(); }
    /// Write access.
    std::string& own() { return m_text.own(); }

    bool operator==(const SharedText&) const = default;

private:
    Shared<std::string> m_text;
};

inline std::ostream& operator<<(std::ostream& stream, const SharedText& text) {
    return stream << *text;
}
