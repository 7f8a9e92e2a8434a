#include "glsl/annotations/hint.h"

#include "base/text.h"
#include "glsl/compile/check.h"
#include "glsl/compile/interface.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
const std::vector<std::string>& known_keys() {
    static const std::vector<std::string> keys{
        "@range",  "@limit", "@scale",     "@label",      "@unit",        "@group",
        "@help",   "@items", "@items_was", "@items_note", "@items_color", "@color",
        "@point",  "@angle", "@parts",     "@identity",   "@was",         "@hidden",
        "@period", "@when",  "@random",    "@photo"};
    return keys;
}

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

class HintReader {
public:
    HintReader(const std::vector<Comment>& comments, const Stage& stage, Diagnostics& errors)
        : m_stage(stage), m_errors(errors) {
        for (const Comment& comment : comments) {  // ignores the stars at the left of a block
                                                   // comment
            int line = comment.line;
            bool is_margin = false;
            for (const char c : comment.text) {
                add(is_margin && c == '*' ? ' ' : c, line);
                is_margin = c == '\n' || (is_margin && (c == '*' || c == ' ' || c == '\t'));
                line += c == '\n' ? 1 : 0;
            }
            add('\n', line);
        }
    }

    Hints read() {
        for (skip_blanks(); m_at < m_text.size(); skip_blanks()) {
            const Location at = here();
            if (m_text[m_at] == '@')
                add_key(read_word(), at);
            else if (is_in_expression())
                add_word(read_expression(at));
            else if (m_text[m_at] == '"' && m_is_inside)
                add_word(read_string(at));
            else
                add_word(read_word());
        }
        return std::move(m_hints);
    }

private:
    void add(char letter, int line) {
        m_text += letter;
        m_lines.push_back(line);
    }

    void skip_blanks() {
        while (m_at < m_text.size() && is_blank(m_text[m_at]))
            ++m_at;
    }

    Location here() const { return location_in(m_stage, m_lines[m_at]); }

    std::string read_word() {
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && !is_blank(m_text[m_at]))
            ++m_at;
        return m_text.substr(begin, m_at - begin);
    }

    // Joins lines of a string with one space.
    static void end_line(std::string& word) {
        constexpr const char* blanks = " \t\r\n\f\v";
        word.resize(word.find_last_not_of(blanks) + 1);
        word.erase(0, word.find_first_not_of(blanks));
        word += ' ';
    }

    std::string read_string(const Location& at) {
        std::string word;
        for (++m_at; m_at < m_text.size(); ++m_at) {
            const char c = m_text[m_at];
            if (c == '"') {
                ++m_at;
                return word;
            }
            const bool is_escape = c == '\\' && m_at + 1 < m_text.size() &&
                                   (m_text[m_at + 1] == '"' || m_text[m_at + 1] == '\\');
            if (c == '\n')
                end_line(word);
            else if (!(is_blank(c) && word.ends_with(' ')))
                word += is_escape ? m_text[++m_at] : c;
        }
        m_errors.push_back({at.file, at.line, "the string that starts here has no closing '\"'"});
        return word;
    }

    bool is_in_expression() const {
        return m_is_inside && m_is_known && m_hints.back().key == "@when";
    }

    // The text up to the next '@' outside quotes, on one line.
    std::string read_expression(const Location& at) {
        std::string text;
        bool is_quoted = false;
        for (; m_at < m_text.size() && (is_quoted || m_text[m_at] != '@'); ++m_at) {
            const char c = m_text[m_at];
            const bool is_escaped = text.ends_with('\\') && is_quoted;
            is_quoted = is_quoted != (c == '"' && !is_escaped);
            if (!(is_blank(c) && text.ends_with(' ')))
                text += is_blank(c) ? ' ' : c;
        }
        if (is_quoted)
            m_errors.push_back(
                {at.file, at.line, "a string in this expression has no closing '\"'"});
        return std::string(trim(text));
    }

    void add_key(const std::string& key, const Location& at) {
        m_is_inside = true;
        m_is_known = std::ranges::find(known_keys(), key) != known_keys().end();
        if (!m_is_known)
            m_errors.push_back(
                {at.file, at.line,
                 fmt::format("unknown annotation '{}'{}", key, did_you_mean(key, known_keys()))});
        else if (find_hint(m_hints, key))
            m_errors.push_back({at.file, at.line, fmt::format("{} is used twice", key)});
        if (m_is_known)
            m_hints.push_back({key, {}, at});
    }

    void add_word(std::string word) {
        if (m_is_inside && m_is_known)
            m_hints.back().words.push_back(std::move(word));
    }

    const Stage& m_stage;
    Diagnostics& m_errors;
    std::string m_text;
    std::vector<int> m_lines;  // of each character
    std::size_t m_at = 0;
    bool m_is_inside = false;  // after the first '@'
    bool m_is_known = false;   // the last key is known
    Hints m_hints;
};
}  // namespace

bool Hint::has_same_text_as(const Hint& other) const {
    const auto is_same = [](const std::string& a, const std::string& b) {
        const auto number = parse_number(a);
        return a == b || (number && number == parse_number(b));
    };
    return key == other.key && std::ranges::equal(words, other.words, is_same);
}

Hints parse_hints(const std::vector<Comment>& comments, const Stage& stage, Diagnostics& errors) {
    return HintReader(comments, stage, errors).read();
}

const Hint* find_hint(const Hints& hints, std::string_view key) {
    const auto found = std::ranges::find(hints, key, &Hint::key);
    return found == hints.end() ? nullptr : &*found;
}

void merge_hints(Hints& hints, const Hints& others, const std::string& name, Diagnostics& errors) {
    for (const Hint& other : others) {
        const Hint* const same = find_hint(hints, other.key);
        if (!same)
            hints.push_back(other);
        else if (!same->has_same_text_as(other))
            errors.push_back({other.at.file, other.at.line,
                              fmt::format("{} of '{}' differs from another declaration{}",
                                          other.key, name, location_suffix(same->at))});
    }
}
