#pragma once

#include <string>
#include <string_view>

/// The first letters of a list's item, as the user types them. A pause of a second starts again.
class TypedPrefix {
public:
    /// Adds the letters typed in a frame at this time in seconds.
    void add(std::string_view letters, double seconds);
    /// Whether the label is the first one offered since the last letters that starts with the typed
    /// text. Ignores the case of ASCII letters.
    bool is_found(std::string_view label);

private:
    std::string m_text;
    double m_seconds = 0.0;
    bool m_is_open = false;  // no label was found yet
};
