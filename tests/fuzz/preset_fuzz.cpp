// Presets. The first letter of a text selects the kind of file: JSON, a line of text, a PNG.

#include "formats/preset/preset_format.h"
#include "formats/preset/preset_png.h"
#include "formats/preset/share_line.h"
#include "fuzz/fuzz_files.h"

namespace {
Result<Preset> read_as(char kind, std::string_view text) {
    if (kind == 'p')
        return preset_from_png(text, "preset.png");
    return kind == 'l' ? parse_share_line(text) : parse_preset(text, "preset.json");
}
}  // namespace

void fuzz_one(std::string_view input) {
    if (input.empty())
        return;
    const auto preset = read_as(input.front(), input.substr(1));
    if (!preset)
        return require_messages(preset.error());
    const auto again = parse_preset(preset_to_json(*preset), "again.json");
    require(again.has_value(), "a written preset can be read");
    require(preset_to_json(*again) == preset_to_json(*preset), "a preset stays the same");
}
