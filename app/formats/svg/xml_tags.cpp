#include "formats/svg/xml_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace {
constexpr std::size_t most_tags = 200000;

std::string without_prefix(std::string_view name) {
    const std::size_t colon = name.rfind(':');
    return std::string(colon == std::string_view::npos ? name : name.substr(colon + 1));
}

bool is_space(char character) {
    return std::isspace(static_cast<unsigned char>(character)) != 0;
}

std::string with_entities_resolved(std::string_view text) {
    constexpr std::pair<std::string_view, char> entities[] = {
        {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
    std::string resolved;
    for (std::size_t i = 0; i < text.size();) {
        const auto found = std::find_if(
            std::begin(entities), std::end(entities),
            [&](const auto& entity) { return text.substr(i).starts_with(entity.first); });
        if (found == std::end(entities)) {
            resolved += text[i++];
        } else {
            resolved += found->second;
            i += found->first.size();
        }
    }
    return resolved;
}

class TagReader {
public:
    TagReader(std::string_view text, const std::filesystem::path& file)
        : m_text(text), m_file(file) {}

    Result<std::vector<XmlTag>> read() {
        while (m_problem.empty() && move_to(m_text.find('<', m_at)))
            read_markup();
        if (m_problem.empty() && m_tags.empty())
            m_problem = "the file has no XML tags";
        if (!m_problem.empty())
            return fail({m_file, m_line, m_problem});
        return std::move(m_tags);
    }

private:
    // False at the end of the text.
    bool move_to(std::size_t place) {
        const std::size_t end = std::min(place, m_text.size());
        m_line +=
            static_cast<int>(std::count(m_text.begin() + static_cast<std::ptrdiff_t>(m_at),
                                        m_text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        m_at = end;
        return place < m_text.size();
    }

    bool skip_past(std::string_view mark) {
        const std::size_t found = m_text.find(mark, m_at);
        if (found == std::string_view::npos) {
            m_problem = "the file ends inside a tag or comment";
            return false;
        }
        move_to(found + mark.size());
        return true;
    }

    void read_markup() {
        const std::string_view rest = m_text.substr(m_at);
        if (rest.starts_with("<!--"))
            skip_past("-->");
        else if (rest.starts_with("<![CDATA["))
            skip_past("]]>");
        else if (rest.starts_with("<?"))
            skip_past("?>");
        else if (rest.starts_with("<!"))
            skip_declaration();
        else
            read_tag();
    }

    // A DOCTYPE may contain declarations in brackets.
    void skip_declaration() {
        const std::size_t end = m_text.find('>', m_at);
        const std::size_t bracket = m_text.find('[', m_at);
        if (bracket < end && !skip_past("]"))
            return;
        skip_past(">");
    }

    void read_tag() {
        XmlTag tag;
        tag.line = m_line;
        move_to(m_at + 1);
        tag.is_closing = m_at < m_text.size() && m_text[m_at] == '/';
        if (tag.is_closing)
            move_to(m_at + 1);
        tag.name = without_prefix(read_name());
        if (tag.name.empty())
            m_problem = "expected a tag name after '<'";
        while (m_problem.empty() && !read_end(tag))
            read_attribute(tag);
        if (m_tags.size() >= most_tags)
            m_problem = fmt::format("too many tags; the limit is {}", most_tags);
        m_tags.push_back(std::move(tag));
    }

    void skip_space() {
        while (m_at < m_text.size() && is_space(m_text[m_at]))
            move_to(m_at + 1);
    }

    std::string_view read_name() {
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && !is_space(m_text[m_at]) &&
               std::string_view("<>/='\"").find(m_text[m_at]) == std::string_view::npos)
            move_to(m_at + 1);
        return m_text.substr(begin, m_at - begin);
    }

    bool read_end(XmlTag& tag) {
        skip_space();
        tag.is_empty = m_text.substr(m_at).starts_with("/>");
        if (!tag.is_empty && !m_text.substr(m_at).starts_with(">"))
            return false;
        move_to(m_at + (tag.is_empty ? 2 : 1));
        return true;
    }

    void read_attribute(XmlTag& tag) {
        const std::string name = without_prefix(read_name());
        skip_space();
        if (name.empty() || m_at >= m_text.size() || m_text[m_at] != '=') {
            m_problem = "expected an attribute name=\"value\"";
            return;
        }
        move_to(m_at + 1);
        skip_space();
        const char quote = m_at < m_text.size() ? m_text[m_at] : '\0';
        const std::size_t end = m_text.find(quote, m_at + 1);
        if ((quote != '"' && quote != '\'') || end == std::string_view::npos) {
            m_problem = fmt::format("the value of '{}' must be in quotes", name);
            return;
        }
        tag.attributes.insert_or_assign(
            name, with_entities_resolved(m_text.substr(m_at + 1, end - m_at - 1)));
        move_to(end + 1);
    }

    std::string_view m_text;
    const std::filesystem::path& m_file;
    std::size_t m_at = 0;
    int m_line = 1;
    std::string m_problem;
    std::vector<XmlTag> m_tags;
};
}  // namespace

Result<std::vector<XmlTag>> parse_xml_tags(std::string_view text,
                                           const std::filesystem::path& file) {
    return TagReader(text, file).read();
}
