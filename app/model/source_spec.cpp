#include "model/source_spec.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace {
constexpr std::array<std::string_view, 4> fit_names{"stretch", "whole", "crop", "integer"};
constexpr double largest_aspect = 16.0;
constexpr double largest_rate = 1000.0;

Result<double> number_in(std::string_view setting, double low, double high) {
    const std::string_view text = setting.substr(setting.find('=') + 1);
    const auto number = parse_number(text);
    if (!number || !(*number >= low && *number <= high))
        return fail({{},
                     0,
                     fmt::format("'{}': a number from {} to {} belongs there", setting,
                                 format_number(low), format_number(high))});
    return *number;
}

// One setting at the end of a source; nothing where the text is none.
std::optional<Result<void>> take_setting(std::string_view setting, SourceSpec& source) {
    const std::string_view key = setting.substr(0, setting.find('='));
    const std::string_view word = setting.substr(std::min(key.size() + 1, setting.size()));
    const auto take = [](Result<double> number, double& into) -> Result<void> {
        if (!number)
            return fail(number.error());
        into = *number;
        return {};
    };
    if (key.size() == setting.size())
        return std::nullopt;
    if (key == "aspect")
        return take(number_in(setting, 1.0 / largest_aspect, largest_aspect), source.aspect);
    if (key == "rate")
        return take(number_in(setting, 0.0, largest_rate), source.rate);
    if (key == "loop" && (word == "on" || word == "off")) {
        source.loops = word == "on";
        return Result<void>();
    }
    if (key == "loop")
        return fail({{}, 0, fmt::format("'{}': 'on' or 'off' belongs there", setting)});
    if (key != "fit")
        return std::nullopt;
    if (const auto fit = find_fit(word)) {
        source.fit = *fit;
        return Result<void>();
    }
    return fail({{},
                 0,
                 fmt::format("'{}': there is no such fit; there are: {}", setting,
                             fmt::join(fit_names, ", "))});
}
}  // namespace

std::string_view fit_name(Fit fit) {
    return fit_names[static_cast<std::size_t>(fit)];
}

std::optional<Fit> find_fit(std::string_view name) {
    const auto found = std::ranges::find(fit_names, name);
    return found == fit_names.end() ? std::nullopt
                                    : std::optional(static_cast<Fit>(found - fit_names.begin()));
}

Result<SourceSpec> parse_source(std::string_view text, Fit usual) {
    SourceSpec source;
    source.fit = usual;
    // From the end on, so that the first of two equal settings would win; none is there twice.
    std::vector<std::string_view> pieces = split(text, ',');
    std::vector<std::string_view> own;
    while (pieces.size() > 1) {
        const auto taken = take_setting(pieces.back(), source);
        if (taken && !*taken)
            return fail(taken->error());
        if (!taken && !text.starts_with("pattern:"))
            break;
        if (!taken)
            own.insert(own.begin(), pieces.back());
        pieces.pop_back();
    }
    pieces.insert(pieces.end(), own.begin(), own.end());
    source.picture = fmt::format("{}", fmt::join(pieces, ","));
    if (source.picture.empty())
        return fail({{}, 0, "a source is a file or pattern:NAME"});
    return source;
}

std::string to_string(const SourceSpec& source) {
    std::string text = source.picture;
    if (source.fit != Fit::stretch)
        text += fmt::format(",fit={}", fit_name(source.fit));
    if (source.aspect != 1.0)
        text += ",aspect=" + format_number(source.aspect);
    if (source.rate != 0.0)
        text += ",rate=" + format_number(source.rate);
    if (!source.loops)
        text += ",loop=off";
    return text;
}
