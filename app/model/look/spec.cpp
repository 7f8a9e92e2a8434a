#include "model/look/spec.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
Spec::Setting setting_from(std::string_view text) {
    if (const auto number = parse_number(text))
        return *number;
    return std::string(text);
}

std::string to_string(const Spec::Setting& setting) {
    if (const double* number = std::get_if<double>(&setting))
        return format_number(*number);
    return std::get<std::string>(setting);
}
}  // namespace

namespace {
/// The text between two commas, without its quotes.
struct Piece {
    std::string key;  // "": no key
    std::string value;
    std::string whole;  // as written, with blanks
    bool has_key = false;
    bool is_quoted = false;
};

bool is_key(std::string_view text) {
    return !text.empty() && text.find_first_not_of(
                                "abcdefghijklmnopqrstuvwxyz"
                                "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string_view::npos;
}

/// Splits settings at commas outside quotes.
class PieceReader {
public:
    explicit PieceReader(std::string_view text) : m_text(text) {}

    bool is_at_end() const { return m_at > m_text.size(); }
    bool is_unclosed() const { return m_is_unclosed; }

    Piece next() {
        Piece piece;
        const std::size_t begin = m_at;
        const std::size_t end = std::min(m_text.find(',', m_at), m_text.size());
        const std::size_t equals = m_text.find('=', m_at);
        std::size_t value = m_at;
        if (equals < end && m_text[m_at] != '"' &&
            is_key(trim(m_text.substr(m_at, equals - m_at)))) {
            piece.has_key = true;
            piece.key = trim(m_text.substr(m_at, equals - m_at));
            value = equals + 1;
        }
        if (value < m_text.size() && m_text[value] == '"') {
            piece.is_quoted = true;
            piece.value = quoted(value + 1);
        } else {
            piece.value = m_text.substr(value, end - value);
            m_at = end + 1;
        }
        piece.whole = m_text.substr(begin, std::min(m_at - 1, m_text.size()) - begin);
        return piece;
    }

private:
    // The text from `at` to the closing quote; text between the quote and the comma is dropped.
    std::string quoted(std::size_t at) {
        std::string value;
        for (; at < m_text.size() && m_text[at] != '"'; ++at) {
            const bool is_escape = m_text[at] == '\\' && at + 1 < m_text.size();
            at += is_escape ? 1 : 0;
            value += m_text[at];
        }
        m_is_unclosed = m_is_unclosed || at >= m_text.size();
        m_at = std::min(m_text.find(',', std::min(at, m_text.size())), m_text.size()) + 1;
        return value;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    bool m_is_unclosed = false;
};

// Whether the first piece is bare text, as in "a=b.wav": not a setting, and not a plain word or
// number.
bool is_fragment_text(const Piece& piece, std::string_view kind, HasSetting has_setting) {
    if (!piece.has_key)
        return true;
    const bool is_plain =
        parse_number(piece.value) || piece.value.find_first_of("./ ") == std::string::npos;
    return has_setting && !has_setting(kind, piece.key) && !is_plain;
}
}  // namespace

Result<Spec> parse_spec(std::string_view text, HasSetting has_setting) {
    const std::size_t colon = text.find(':');
    Spec spec{std::string(trim(text.substr(0, colon))), {}};
    if (spec.kind.empty())
        return fail({{}, 0, "expected the signal kind first, as in 'lissajous:x=3,y=2'"});
    if (colon == std::string_view::npos)
        return spec;
    PieceReader reader(text.substr(colon + 1));
    std::string* bare = nullptr;  // the bare text, while pieces without a key belong to it
    for (bool is_first = true; !reader.is_at_end(); is_first = false) {
        const Piece piece = reader.next();
        if (is_first && is_fragment_text(piece, spec.kind, has_setting)) {
            Spec::Setting& setting = spec.settings[""];
            setting = piece.is_quoted ? piece.value : piece.whole;
            bare = piece.is_quoted ? nullptr : &std::get<std::string>(setting);
        } else if (piece.has_key) {
            spec.settings[piece.key] =
                piece.is_quoted ? Spec::Setting(piece.value) : setting_from(trim(piece.value));
            bare = nullptr;
        } else if (bare) {
            *bare += ',' + piece.whole;
        } else {
            return fail({{}, 0, fmt::format("expected key=value, got '{}'", piece.whole)});
        }
    }
    if (reader.is_unclosed())
        return fail({{}, 0, fmt::format("missing closing quote in '{}'", text)});
    return spec;
}

namespace {
// In the form that parse_spec() reads. A bare text with '=' needs quotes.
std::string written(const std::string& key, const Spec::Setting& setting) {
    std::string text = to_string(setting);
    const bool is_text = std::holds_alternative<std::string>(setting);
    const bool is_plain = text.find_first_of(key.empty() ? ",=" : ",") == std::string::npos &&
                          !text.starts_with('"') && trim(text) == text;
    if (!is_text || is_plain)
        return text;
    std::string quoted = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\')
            quoted += '\\';
        quoted += letter;
    }
    return quoted + '"';
}
}  // namespace

std::string to_string(const Spec& spec) {
    std::string text = spec.kind;
    char separator = ':';
    for (const auto& [key, setting] : spec.settings) {
        text += separator + (key.empty() ? "" : key + '=') + written(key, setting);
        separator = ',';
    }
    return text;
}
