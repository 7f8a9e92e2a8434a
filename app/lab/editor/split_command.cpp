#include "lab/editor/split_command.h"

#include <utility>

namespace {
/// Parses a command character by character.
class CommandReader {
public:
    explicit CommandReader(std::string_view text) : m_text(text) {}

    std::optional<std::vector<std::string>> read() {
        while (m_at < m_text.size())
            if (!read_piece(m_text[m_at++]))
                return std::nullopt;
        end_word();
        return std::move(m_words);
    }

private:
    // A separator, a quoted part or one character; false: an unterminated quote.
    bool read_piece(char letter) {
        if (letter == ' ' || letter == '\t' || letter == '\n') {
            end_word();
            return true;
        }
        m_is_in_word = true;
        if (letter == '\'')
            return read_single();
        if (letter == '"')
            return read_double();
        if (letter != '\\') {
            m_word += letter;
            return true;
        }
        if (m_at == m_text.size())
            return false;
        m_word += m_text[m_at++];
        return true;
    }

    bool read_single() {
        const std::size_t end = m_text.find('\'', m_at);
        if (end == std::string_view::npos)
            return false;
        m_word += m_text.substr(m_at, end - m_at);
        m_at = end + 1;
        return true;
    }

    // In double quotes, a backslash escapes only $ ` " \.
    bool read_double() {
        constexpr std::string_view quoted = "$`\"\\";
        while (m_at < m_text.size()) {
            const char letter = m_text[m_at++];
            if (letter == '"')
                return true;
            const bool is_quoted = letter == '\\' && m_at < m_text.size() &&
                                   quoted.find(m_text[m_at]) != std::string_view::npos;
            m_word += is_quoted ? m_text[m_at++] : letter;
        }
        return false;
    }

    void end_word() {
        if (std::exchange(m_is_in_word, false))
            m_words.push_back(std::exchange(m_word, {}));
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::vector<std::string> m_words;
    std::string m_word;
    bool m_is_in_word = false;  // "" is also a word
};
}  // namespace

std::optional<std::vector<std::string>> split_command(std::string_view text) {
    return CommandReader(text).read();
}
