#include "formats/effect/effect_request.h"

#include "base/text.h"

#include <fmt/format.h>

namespace {
/// Collects lines, and comments them out.
class CommentLines {
public:
    explicit CommentLines(std::string_view mark) : m_mark(mark) {}

    void add(std::string_view text, std::string_view indent = "") {
        for (const std::string_view line : split_lines(text)) {
            m_text += fmt::format("{} {}{}", m_mark, indent, line);
            m_text += line.ends_with('\\') ? ".\n" : "\n";  // which would continue the comment
        }
    }
    std::string text() && { return std::move(m_text); }

private:
    std::string_view m_mark;
    std::string m_text;
};
}  // namespace

std::string notice_comment(const Look& look, const SourceNotices& notices, std::string_view mark) {
    CommentLines lines(mark);
    lines.add(look.name + ", exported by Afterglow.");
    lines.add(look.about);
    if (!look.author.empty())
        lines.add("Author: " + look.author);
    lines.add("Licence: " + (look.license.empty() ? "not stated" : look.license));
    std::string plain;  // files without a notice of their own
    for (const auto& [file, notice] : notices) {
        if (notice == SourceNotice{"not stated", ""}) {
            plain += (plain.empty() ? "" : ", ") + file;
            continue;
        }
        lines.add(fmt::format("{}: {}", file, notice.license));
        lines.add(notice.text, "    ");
    }
    if (!plain.empty())
        lines.add("Files under the licence of the look: " + plain);
    return std::move(lines).text();
}
