#include "formats/slang/expand.h"

#include "formats/slang/similar_file.h"
#include "formats/slang/slang_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_open_texts = 64;
constexpr int max_includes_in_all = 16384;
constexpr std::size_t max_expanded_bytes = std::size_t{8} << 20;
constexpr std::size_t max_expansion_errors = 32;
constexpr const char* too_large_expanded =
    "the shader with its includes is larger than the limit of 8 MiB";

class Expander {
public:
    explicit Expander(SlangFiles& files) : m_files(files) {}

    Result<std::vector<SlangPiece>> expand(const fs::path& file) {
        const auto text = m_files.read(file);
        if (!text)
            return fail(text.error());
        add(**text);
        if (!m_errors.empty())
            return fail(std::move(m_errors));
        return std::move(m_pieces);
    }

private:
    void error(const SlangText& in, int line, std::string message) {
        m_errors.push_back({in.file, line, std::move(message)});
        m_is_over = m_is_over || m_errors.size() >= max_expansion_errors;
    }

    void end_with(const SlangText& in, int line, std::string message) {
        error(in, line, std::move(message));
        m_is_over = true;
    }

    void add(const SlangText& text) {
        m_open.push_back(&text);
        std::size_t done = 0;
        int line = 1;
        for (const SlangDirective& directive : text.directives) {
            if (m_is_over)
                break;
            add_lines(text, done, directive.begin, line,
                      static_cast<std::size_t>(directive.line - line));
            obey(text, directive);
            done = directive.end;
            line = directive.line + 1;
        }
        add_lines(text, done, text.text.size(), line,
                  static_cast<std::size_t>(text.line_count + 1 - line));
        m_open.pop_back();
    }

    void add_lines(const SlangText& text, std::size_t begin, std::size_t end, int line,
                   std::size_t count) {
        if (count == 0 || m_is_over)
            return;
        m_bytes += end - begin;
        if (m_bytes > max_expanded_bytes)
            return end_with(text, line, too_large_expanded);
        m_pieces.push_back(
            {&text, line, count, std::string_view(text.text).substr(begin, end - begin), nullptr});
    }

    void obey(const SlangText& text, const SlangDirective& directive) {
        using Kind = SlangDirective::Kind;
        if (directive.kind == Kind::damaged_include)
            return error(text, directive.line, "expected #include \"file\"");
        if (directive.kind == Kind::include || directive.kind == Kind::include_optional)
            return include(text, directive);
        m_bytes += directive.end - directive.begin;
        if (m_bytes > max_expanded_bytes)
            return end_with(text, directive.line, too_large_expanded);
        m_pieces.push_back({&text, directive.line, 1, {}, &directive});
    }

    void include(const SlangText& text, const SlangDirective& directive) {
        if (m_is_over)
            return;
        if (std::string fault = fault_of_slang_path(directive.argument); !fault.empty())
            return error(text, directive.line, std::move(fault));
        const fs::path wanted = sibling_path(text.file, directive.argument);
        const auto found = m_files.read(wanted);
        if (!found) {
            std::error_code unknown;
            const bool is_left_out = directive.kind == SlangDirective::Kind::include_optional &&
                                     !fs::exists(wanted, unknown);
            if (!is_left_out)
                refuse(text, directive, found.error().front());
            return;
        }
        if (std::string circle = circle_through(**found); !circle.empty())
            return error(text, directive.line, fmt::format("circular #include: {}", circle));
        if (m_open.size() >= max_open_texts)
            return error(text, directive.line,
                         fmt::format("includes are nested deeper than the limit of {} levels",
                                     max_open_texts));
        if (++m_included > max_includes_in_all)
            return end_with(text, directive.line,
                            fmt::format("the shader has more includes than the limit of {}",
                                        max_includes_in_all));
        add(**found);
    }

    // Errors about a whole file are reported at the #include.
    void refuse(const SlangText& text, const SlangDirective& directive, const Diagnostic& reason) {
        if (reason.line > 0) {
            m_errors.push_back(reason);
            return;
        }
        error(text, directive.line,
              fmt::format("can't include '{}' ({}): {}{}", directive.argument, reason.file.string(),
                          reason.message, similar_file(reason.file, text.file)));
    }

    // "a.inc -> b.inc -> a.inc", or "".
    std::string circle_through(const SlangText& next) const {
        const auto first = std::ranges::find(m_open, &next);
        std::string chain;
        for (auto link = first; link != m_open.end(); ++link)
            chain += (*link)->file.filename().string() + " -> ";
        return chain.empty() ? chain : chain + next.file.filename().string();
    }

    SlangFiles& m_files;
    std::vector<SlangPiece> m_pieces;
    std::vector<const SlangText*> m_open;  // from the shader to the current text
    Diagnostics m_errors;
    std::size_t m_bytes = 0;
    int m_included = 0;
    bool m_is_over = false;  // a limit was exceeded and reported
};
}  // namespace

Result<std::vector<SlangPiece>> expand_slang(const fs::path& file, SlangFiles& files) {
    return Expander(files).expand(file);
}
