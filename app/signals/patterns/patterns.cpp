#include "signals/patterns/patterns.h"

#include "base/text.h"
#include "signals/patterns/glyph_rain.h"
#include "signals/patterns/noise_patterns.h"
#include "signals/patterns/pattern.h"
#include "signals/patterns/pixel_art.h"
#include "signals/patterns/terminal_page.h"
#include "signals/patterns/test_cards.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
const std::vector<Pattern>& patterns() {
    static const std::vector<Pattern> all = [] {
        std::vector<Pattern> list = test_cards();
        list.push_back(terminal_page_pattern());
        list.push_back(glyph_rain_pattern());
        list.push_back(harbour_pattern());
        for (Pattern& pattern : noise_patterns())
            list.push_back(std::move(pattern));
        return list;
    }();
    return all;
}

const Pattern* find_pattern(std::string_view name) {
    const auto found = std::ranges::find_if(
        patterns(), [&](const Pattern& pattern) { return pattern.info.name == name; });
    return found == patterns().end() ? nullptr : &*found;
}

Result<PatternSize> size_of(std::string_view text) {
    const std::string_view whole = text;
    const bool is_interlaced = text.ends_with('i');
    text.remove_suffix(is_interlaced ? 1 : 0);
    const std::size_t cross = text.find('x');
    const auto width = parse_integer(text.substr(0, cross));
    const bool has_cross = cross != std::string_view::npos;
    const auto height = parse_integer(has_cross ? text.substr(cross + 1) : std::string_view());
    constexpr int largest = 8192;
    if (!width || !height || *width < 1 || *height < 1 || *width > largest || *height > largest)
        return fail(
            {{}, 0, fmt::format("expected size=640x480 or size=640x480i, got 'size={}'", whole)});
    return PatternSize{{*width, *height}, is_interlaced};
}

// Interleaves the rows of the latest field and of the previous field.
Picture woven(const Pattern& pattern, Extent extent, double seconds) {
    constexpr double fields = 60.0;  // per second
    constexpr double rounding = 1e-6;
    const auto field = static_cast<std::int64_t>(std::floor(seconds * fields + rounding));
    const auto drawn = [&](std::int64_t number) {
        return pattern.draw(extent, static_cast<double>(number) / fields);
    };
    Picture picture = drawn(field);
    if (!pattern.info.moves || field <= 0)
        return picture;
    const Picture before = drawn(field - 1);
    const std::size_t row = picture.index(0, 1);
    for (auto y = static_cast<std::size_t>((field + 1) % 2);
         y < static_cast<std::size_t>(extent.height); y += 2)
        std::copy_n(before.pixels.data() + y * row, row, picture.pixels.data() + y * row);
    return picture;
}
}  // namespace

const std::vector<PatternInfo>& all_patterns() {
    static const std::vector<PatternInfo> info = [] {
        std::vector<PatternInfo> list;
        for (const Pattern& pattern : patterns())
            list.push_back(pattern.info);
        return list;
    }();
    return info;
}

std::string_view pattern_name(std::string_view text) {
    return text.substr(0, text.find(','));
}

std::string name_of_pattern(const SourceSpec& source) {
    constexpr std::size_t prefix = std::string_view("pattern:").size();
    return source.is_pattern() ? std::string(pattern_name(source.picture.substr(prefix)))
                               : std::string();
}

std::string pattern_of_size(std::string_view name, const std::optional<PatternSize>& size) {
    return size ? fmt::format("{},size={}x{}{}", name, size->extent.width, size->extent.height,
                              size->is_interlaced ? "i" : "")
                : std::string(name);
}

Result<Picture> make_pattern(std::string_view text, double seconds) {
    const std::string_view name = pattern_name(text);
    const Pattern* pattern = find_pattern(name);
    if (!pattern) {
        std::vector<std::string> names;
        for (const Pattern& known : patterns())
            names.push_back(known.info.name);
        const std::string guess = did_you_mean(name, names);
        return fail({{},
                     0,
                     guess.empty() ? fmt::format("unknown pattern '{}'; use one of: {}", name,
                                                 fmt::join(names, ", "))
                                   : fmt::format("unknown pattern '{}'{}", name, guess)});
    }
    if (name.size() == text.size())
        return pattern->draw(pattern->initial, seconds);
    const std::string_view setting = text.substr(name.size() + 1);
    if (!setting.starts_with("size="))
        return fail({{}, 0, fmt::format("unknown pattern setting '{}'; use size=WxH", setting)});
    const auto size = size_of(setting.substr(5));
    if (!size)
        return fail(size.error());
    return size->is_interlaced ? woven(*pattern, size->extent, seconds)
                               : pattern->draw(size->extent, seconds);
}

bool is_moving_pattern(std::string_view text) {
    const Pattern* pattern = find_pattern(pattern_name(text));
    return pattern && pattern->info.moves;
}
