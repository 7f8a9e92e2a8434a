#include "gpu/driver_log.h"

#include <array>
#include <optional>
#include <regex>

namespace gpu {

namespace {
struct Remark {
    int line = 0;
    std::string kind;
    std::string message;
};

std::optional<Remark> parse_remark(std::string_view line) {
    // Line number, kind and message are the groups named here, by driver.
    struct Shape {
        std::regex pattern;
        std::size_t number, kind, message;
    };
    static const std::array<Shape, 3> shapes{{
        {std::regex(R"(^\d+:(\d+)\(\d+\): (?:preprocessor )?(\w+): (.*)$)"), 1, 2, 3},
        {std::regex(R"(^\d+\((\d+)\) : (\w+) \w+: (.*)$)"), 1, 2, 3},
        {std::regex(R"(^(\w+): \d+:(\d+): (.*)$)"), 2, 1, 3},
    }};
    for (const Shape& shape : shapes) {
        std::match_results<std::string_view::const_iterator> match;
        if (!std::regex_match(line.begin(), line.end(), match, shape.pattern))
            continue;
        const auto number = parse_integer(match[shape.number].str());
        return Remark{number.value_or(0), to_lower(match[shape.kind].str()),
                      match[shape.message].str()};
    }
    return std::nullopt;
}
}  // namespace

Diagnostics parse_driver_log(std::string_view log, const Stage& stage) {
    Diagnostics diagnostics;
    for (const std::string_view line : split_lines(log)) {
        constexpr std::size_t longest = 2000;  // a regular expression recurses a step a letter
        const auto remark = parse_remark(trim(line).substr(0, longest));
        if (!remark)
            continue;
        Location place = origin_of(stage.lines, remark->line);
        if (stage.lines.empty())
            place = {stage.file, remark->line};
        const bool is_warning = remark->kind == "warning";
        diagnostics.push_back({place.file, place.line, "the graphics driver: " + remark->message,
                               is_warning ? Severity::warning : Severity::error});
    }
    if (!has_errors(diagnostics)) {
        const std::string_view whole = trim(log).substr(0, trim(log).find('\0'));
        diagnostics.push_back(
            {stage.file, 0,
             "the graphics driver: " + (whole.empty() ? std::string("refused, "
                                                                    "without a word")
                                                      : std::string(whole))});
    }
    return diagnostics;
}

}  // namespace gpu
