#include "gpu/driver_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace gpu {

namespace {
struct Remark {
    int line = 0;
    std::string kind;
    std::string message;
};

// Parses pieces from the front of a line; after the first missing piece all others fail too.
class Scanner {
public:
    explicit Scanner(std::string_view line) : m_rest(line) {}

    Scanner& text(std::string_view wanted) {
        m_is_good = m_is_good && m_rest.starts_with(wanted);
        m_rest.remove_prefix(m_is_good ? wanted.size() : 0);
        return *this;
    }
    Scanner& text_if_there(std::string_view perhaps) {
        m_rest.remove_prefix(m_is_good && m_rest.starts_with(perhaps) ? perhaps.size() : 0);
        return *this;
    }
    Scanner& number(int* number) {
        return piece("0123456789",
                     [&](std::string_view digits) { *number = parse_integer(digits).value_or(0); });
    }
    Scanner& word(std::string* word) {
        return piece("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789",
                     [&](std::string_view letters) { *word = to_lower(letters); });
    }
    std::optional<Remark> remark(int line, std::string kind) const {
        if (!m_is_good)
            return std::nullopt;
        return Remark{line, std::move(kind), std::string(m_rest)};
    }

private:
    template <class Use>
    Scanner& piece(std::string_view letters, const Use& use) {
        const std::size_t length = std::min(m_rest.find_first_not_of(letters), m_rest.size());
        m_is_good = m_is_good && length > 0;
        if (m_is_good)
            use(m_rest.substr(0, length));
        m_rest.remove_prefix(m_is_good ? length : 0);
        return *this;
    }

    std::string_view m_rest;
    bool m_is_good = true;
};

std::optional<Remark> parse_remark(std::string_view line) {
    int string = 0;  // index of the source string: always 0, the only one
    int number = 0;
    int column = 0;
    std::string kind;
    std::string code;
    Scanner mesa(line);
    mesa.number(&string).text(":").number(&number).text("(").number(&column).text("): ");
    mesa.text_if_there("preprocessor ").word(&kind).text(": ");
    if (auto remark = mesa.remark(number, kind))
        return remark;
    Scanner nvidia(line);
    nvidia.number(&string).text("(").number(&number).text(") : ").word(&kind).text(" ");
    nvidia.word(&code).text(": ");
    if (auto remark = nvidia.remark(number, kind))
        return remark;
    Scanner others(line);
    others.word(&kind).text(": ").number(&string).text(":").number(&number).text(": ");
    return others.remark(number, kind);
}
}  // namespace

Diagnostics parse_driver_log(std::string_view log, const Stage& stage) {
    Diagnostics diagnostics;
    for (const std::string_view line : split_lines(log)) {
        const auto remark = parse_remark(trim(line));
        if (!remark)
            continue;
        Location location = origin_of(stage.lines, remark->line);
        if (stage.lines.empty())
            location = {stage.file, remark->line};
        const bool is_warning = remark->kind == "warning";
        diagnostics.push_back({location.file, location.line,
                               fmt::format("graphics driver: {}", remark->message),
                               is_warning ? Severity::warning : Severity::error});
    }
    if (!has_errors(diagnostics)) {
        const std::string_view whole = trim(log);
        diagnostics.push_back({stage.file, 0,
                               whole.empty()
                                   ? "the graphics driver rejected the shader without a message"
                                   : fmt::format("graphics driver: {}", whole)});
    }
    return diagnostics;
}

}  // namespace gpu
