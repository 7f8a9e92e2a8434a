#include "formats/settings/sound_settings_format.h"

#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"

#include <nlohmann/json.hpp>

namespace {
constexpr FileFormat sound_file{"afterglow-sound", 1};
}  // namespace

std::string sound_settings_to_json(const SoundSettings& settings) {
    return json_text({{"format", sound_file.name},
                      {"version", sound_file.newest_version},
                      {"output", settings.output},
                      {"input", settings.input},
                      {"rate", settings.rate},
                      {"buffer", settings.buffer},
                      {"picture_delay_ms", settings.picture_delay_ms},
                      {"beam_level", settings.beam_level}});
}

Result<SoundSettings> parse_sound_settings(std::string_view text,
                                           const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    SoundSettings settings;
    if (accept_header(reader, sound_file)) {
        settings.output = reader.text("output");
        settings.input = reader.text("input");
        settings.rate = reader.whole("rate", 0, 0, 768000);
        settings.buffer = reader.whole("buffer", settings.buffer, 16, 65536);
        settings.picture_delay_ms = reader.number("picture_delay_ms", 0.0);
        settings.beam_level = reader.number("beam_level", settings.beam_level);
        reader.report_unknown_keys();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return settings;
}
