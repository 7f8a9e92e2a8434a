#include "formats/settings/playlist_format.h"

#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"

#include <nlohmann/json.hpp>

namespace {
constexpr FileFormat playlist_file{"afterglow-playlist", 1};

double bounded_number(ObjectReader& reader, std::string_view key, double fallback, double low,
                      double high) {
    const double number = reader.number(key, fallback);
    const JsonValue* value = reader.find(key);
    if (value && !(number >= low && number <= high)) {
        reader.problem(
            *value, fmt::format("'{}' must be between {} and {}, got {}", key, format_number(low),
                                format_number(high), format_number(number)));
        return fallback;
    }
    return number;
}

std::vector<std::string> read_presets(ObjectReader& reader) {
    std::vector<std::string> presets;
    const JsonValue* list = reader.require("presets");
    if (!list || !reader.expect(*list, JsonValue::Kind::array))
        return presets;
    if (list->children.size() > max_playlist_presets) {
        reader.problem(*list, fmt::format("the list has {} presets; the limit is {}",
                                          list->children.size(), max_playlist_presets));
        return presets;
    }
    for (const JsonValue& preset : list->children)
        if (reader.expect(preset, JsonValue::Kind::text))
            presets.push_back(preset.text);
    return presets;
}
}  // namespace

std::string playlist_to_json(const Playlist& playlist) {
    return json_text({{"format", playlist_file.name},
                      {"version", playlist_file.newest_version},
                      {"presets", playlist.presets},
                      {"every", playlist.every},
                      {"unit", playlist.unit == Playlist::Unit::bars ? "bars" : "seconds"},
                      {"morph", playlist.morph_seconds},
                      {"shuffle", playlist.is_shuffled}});
}

Result<Playlist> parse_playlist(std::string_view text, const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    Playlist playlist;
    if (accept_header(reader, playlist_file)) {
        playlist.presets = read_presets(reader);
        playlist.every = bounded_number(reader, "every", playlist.every, 0.125, max_playlist_every);
        playlist.unit = reader.choice("unit",
                                      Choices<Playlist::Unit>{{"bars", Playlist::Unit::bars},
                                                              {"seconds", Playlist::Unit::seconds}},
                                      playlist.unit);
        playlist.morph_seconds =
            bounded_number(reader, "morph", playlist.morph_seconds, 0.0, max_playlist_morph);
        playlist.is_shuffled = reader.boolean("shuffle", playlist.is_shuffled);
        reader.report_unknown_keys();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return playlist;
}
