#include "model/picture/live_spec.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace {
struct LivePrefix {
    std::string_view text;
    LiveKind kind;
};
constexpr std::array prefixes{
    LivePrefix{"window:", LiveKind::window}, LivePrefix{"screen:", LiveKind::screen},
    LivePrefix{"camera:", LiveKind::camera}, LivePrefix{"pipe:", LiveKind::pipe}};
constexpr int largest_side = 8192;
constexpr int largest_offset = 32767;  // of X11

const LivePrefix* prefix_of(std::string_view picture) {
    const auto found = std::ranges::find_if(
        prefixes, [&](const LivePrefix& prefix) { return picture.starts_with(prefix.text); });
    return found == prefixes.end() ? nullptr : &*found;
}

// "640x480"
std::optional<Extent> extent_in(std::string_view text) {
    const std::size_t by = text.find('x');
    if (by == std::string_view::npos)
        return std::nullopt;
    const auto width = parse_integer(text.substr(0, by));
    const auto height = parse_integer(text.substr(by + 1));
    const auto is_side = [](const auto& side) {
        return side && *side > 0 && *side <= largest_side;
    };
    if (!is_side(width) || !is_side(height))
        return std::nullopt;
    return Extent{static_cast<int>(*width), static_cast<int>(*height)};
}

// "10x20+640+480"
std::optional<ScreenArea> area_in(std::string_view text) {
    const std::size_t plus = text.find('+');
    const std::size_t by = text.substr(0, plus).find('x');
    if (plus == std::string_view::npos || by == std::string_view::npos)
        return std::nullopt;
    std::string size(text.substr(plus + 1));
    std::ranges::replace(size, 'x', '?');
    std::ranges::replace(size, '+', 'x');
    const auto x = parse_integer(text.substr(0, by));
    const auto y = parse_integer(text.substr(by + 1, plus - by - 1));
    const auto extent = extent_in(size);
    const auto is_offset = [](const auto& number) {
        return number && *number >= 0 && *number <= largest_offset;
    };
    if (!is_offset(x) || !is_offset(y) || !extent)
        return std::nullopt;
    return ScreenArea{static_cast<int>(*x), static_cast<int>(*y), *extent};
}

bool is_format_name(std::string_view word) {
    return !word.empty() && std::ranges::all_of(word, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

// The settings of a kind, for errors.
std::string_view settings_of(LiveKind kind) {
    switch (kind) {
        case LiveKind::screen:
            return "area, cursor";
        case LiveKind::camera:
            return "size, rate";
        default:
            return "size, format, rate";
    }
}

Result<void> take_setting(std::string_view piece, LiveSpec& spec) {
    const std::string_view key = piece.substr(0, piece.find('='));
    const std::string_view word = piece.substr(std::min(key.size() + 1, piece.size()));
    const bool is_screen = spec.kind == LiveKind::screen;
    const auto expected = [&](const char* what) {
        return fail({{}, 0, fmt::format("'{}': expected {}", piece, what)});
    };
    if (key == "area" && is_screen) {
        spec.area = area_in(word);
        return spec.area ? Result<void>() : expected("XxY+W+H, such as area=0x0+640+480");
    }
    if (key == "cursor" && is_screen) {
        spec.has_cursor = word == "on";
        return word == "on" || word == "off" ? Result<void>() : expected("'on' or 'off'");
    }
    if (key == "size" && !is_screen) {
        const auto size = extent_in(word);
        spec.size = size.value_or(Extent{});
        return size ? Result<void>() : expected("WxH, such as size=640x480");
    }
    if (key == "format" && spec.kind == LiveKind::pipe) {
        spec.format = word;
        return is_format_name(word) ? Result<void>()
                                    : expected("a pixel format of FFmpeg, such as format=rgb24");
    }
    return fail(
        {{},
         0,
         fmt::format("unknown setting '{}'; use one of: {}", piece, settings_of(spec.kind))});
}
}  // namespace

bool is_live(std::string_view picture) {
    return prefix_of(picture) != nullptr;
}

bool has_live_settings(std::string_view picture) {
    const LivePrefix* prefix = prefix_of(picture);
    return prefix && prefix->kind != LiveKind::window;
}

Result<LiveSpec> parse_live(std::string_view picture) {
    const LivePrefix* prefix = prefix_of(picture);
    if (!prefix)
        return fail({{}, 0, fmt::format("'{}' is not a live source", picture)});
    LiveSpec spec;
    spec.kind = prefix->kind;
    const std::string_view rest = picture.substr(prefix->text.size());
    if (spec.kind == LiveKind::window) {
        if (rest.empty())
            return fail({{}, 0, "'window:' needs a title, such as window:Terminal"});
        spec.name = rest;
        return spec;
    }
    std::vector<std::string_view> pieces = split(rest, ',');
    // "screen:area=..." has no display.
    if (!pieces.empty() && pieces.front().find('=') == std::string_view::npos) {
        spec.name = pieces.front();
        pieces.erase(pieces.begin());
    }
    for (const std::string_view piece : pieces)
        if (auto taken = take_setting(piece, spec); !taken)
            return fail(taken.error());
    if (spec.kind == LiveKind::camera && spec.name.empty())
        return fail({{}, 0, "'camera:' needs a device, such as camera:/dev/video0"});
    if (spec.format.empty() != spec.size.is_empty() && spec.kind == LiveKind::pipe)
        return fail({{}, 0, "raw video needs both size=WxH and format=NAME"});
    return spec;
}
