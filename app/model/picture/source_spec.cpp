#include "model/picture/source_spec.h"

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
                     fmt::format("'{}': expected a number from {} to {}", setting,
                                 format_number(low), format_number(high))});
    return *number;
}

std::string shape_text(const ShapeRatio& shape) {
    return format_number(shape.width) + ":" + format_number(shape.height);
}

Result<void> take_shape(std::string_view setting, std::string_view word, SourceSpec& source) {
    source.shape.reset();
    if (word == "square")
        return {};
    const std::size_t colon = std::min(word.find(':'), word.size());
    const auto width = parse_number(word.substr(0, colon));
    const auto height = parse_number(word.substr(std::min(colon + 1, word.size())));
    const bool is_ratio = width && height && *width > 0.0 && *height > 0.0 &&
                          *width / *height <= largest_aspect && *height / *width <= largest_aspect;
    if (!is_ratio)
        return fail(
            {{}, 0, fmt::format("'{}': expected 'square' or a ratio such as 4:3", setting)});
    source.shape = ShapeRatio{*width, *height};
    return {};
}

Result<void> take_prescale(std::string_view setting, std::string_view word, SourceSpec& source) {
    const auto times = parse_integer(word);
    if (word != "auto" && (!times || *times < 1 || *times > largest_prescale))
        return fail({{},
                     0,
                     fmt::format("'{}': expected 'auto' or a whole number from 1 to {}", setting,
                                 largest_prescale)});
    source.prescaled = word == "auto" ? 0 : static_cast<int>(*times);
    return {};
}

// A setting at the end of a source; nullopt if the text is not a setting.
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
    if (key == "shape")
        return take_shape(setting, word, source);
    if (key == "prescaled")
        return take_prescale(setting, word, source);
    if (key == "rate")
        return take(number_in(setting, 0.0, largest_rate), source.rate);
    if (key == "loop" && (word == "on" || word == "off")) {
        source.loops = word == "on";
        return Result<void>();
    }
    if (key == "loop")
        return fail({{}, 0, fmt::format("'{}': expected 'on' or 'off'", setting)});
    if (key != "fit")
        return std::nullopt;
    if (const auto fit = find_fit(word)) {
        source.fit = *fit;
        return Result<void>();
    }
    return fail(
        {{}, 0, fmt::format("unknown fit '{}'; use one of: {}", word, fmt::join(fit_names, ", "))});
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

Result<SourceSpec> parse_source(std::string_view text, const SourceSpec& usual) {
    SourceSpec source = usual;
    // From the end, so the first of two equal settings wins.
    std::vector<std::string_view> pieces = split(text, ',');
    std::vector<std::string_view> own;
    while (pieces.size() > 1) {
        const auto taken = take_setting(pieces.back(), source);
        if (taken && !*taken)
            return fail(taken->error());
        if (!taken && !text.starts_with("pattern:") && !has_live_settings(text))
            break;
        if (!taken)
            own.insert(own.begin(), pieces.back());
        pieces.pop_back();
    }
    pieces.insert(pieces.end(), own.begin(), own.end());
    source.picture = fmt::format("{}", fmt::join(pieces, ","));
    if (source.picture.empty())
        return fail({{},
                     0,
                     "a source must be a file, pattern:NAME, window:TITLE, screen:, camera:DEVICE "
                     "or pipe:"});
    if (source.shape && source.aspect != 1.0)
        return fail({{}, 0, "a source can have 'aspect' or 'shape', not both"});
    return source;
}

std::string to_string(const SourceSpec& source) {
    std::string text = source.picture;
    if (source.fit != Fit::stretch)
        text += fmt::format(",fit={}", fit_name(source.fit));
    if (source.aspect != 1.0)
        text += ",aspect=" + format_number(source.aspect);
    if (source.shape)
        text += ",shape=" + shape_text(*source.shape);
    if (source.prescaled != 1)
        text += source.prescaled == 0 ? std::string(",prescaled=auto")
                                      : fmt::format(",prescaled={}", source.prescaled);
    if (source.rate != 0.0)
        text += ",rate=" + format_number(source.rate);
    if (!source.loops)
        text += ",loop=off";
    return text;
}

double pixel_aspect(const SourceSpec& source, Extent extent) {
    if (!source.shape || extent.is_empty())
        return source.aspect;
    return source.shape->width / source.shape->height * extent.height / extent.width;
}
