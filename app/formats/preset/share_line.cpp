#include "formats/preset/share_line.h"

#include "base/text.h"
#include "formats/json/json_text.h"
#include "formats/preset/base64url.h"
#include "formats/preset/deflate.h"
#include "formats/preset/preset_format.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace {
constexpr std::string_view scheme = "afterglow:";
constexpr std::string_view version = "1:";

std::string without_blanks(std::string_view text) {
    std::string letters;
    std::copy_if(text.begin(), text.end(), std::back_inserter(letters), [](char letter) {
        return std::string_view(" \t\r\n").find(letter) == std::string_view::npos;
    });
    return letters;
}
}  // namespace

std::string share_line(const Preset& preset, const Look* look) {
    const std::string json = compact_json_text(preset_json(preset, look));
    return std::string(scheme).append(version).append(base64url_encode(deflate_bytes(json)));
}

bool is_share_line(std::string_view text) {
    return trim(text).starts_with(scheme);
}

Result<Preset> parse_share_line(std::string_view text) {
    if (!is_share_line(text))
        return fail(
            {{},
             0,
             "the clipboard doesn't contain an Afterglow preset. Copy a line that starts with "
             "'afterglow:1:'."});
    if (text.size() > 2 * largest_preset)
        return fail({{},
                     0,
                     fmt::format("the shared preset is too large: {} bytes; the limit is {}",
                                 text.size(), 2 * largest_preset)});
    const std::string line = without_blanks(text);
    std::string_view rest = std::string_view(line).substr(scheme.size());
    if (!rest.starts_with(version)) {
        const auto newer = parse_integer(rest.substr(0, rest.find(':')));
        return fail({{},
                     0,
                     newer && *newer > 1
                         ? "the shared preset needs a newer version of Afterglow"
                         : "the shared preset is damaged: it must start with 'afterglow:1:'"});
    }
    rest.remove_prefix(version.size());
    const auto stream = base64url_decode(rest);
    const auto json = stream ? inflate_bytes(*stream, largest_preset) : std::nullopt;
    if (!json)
        return fail({{}, 0, "the shared preset is damaged or incomplete. Copy the whole line."});
    auto preset = parse_preset(*json, {});
    if (!preset)
        for (Diagnostic& reason : preset.error())
            reason = {{}, 0, fmt::format("the shared preset is invalid: {}", reason.message)};
    return preset;
}
