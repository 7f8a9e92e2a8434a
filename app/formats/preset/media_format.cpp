#include "formats/preset/media_format.h"

#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"

#include <nlohmann/json.hpp>

namespace {
constexpr FileFormat media_file{"afterglow-media", 1};
}  // namespace

std::string media_to_json(const std::vector<MediaEntry>& entries) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const MediaEntry& entry : entries)
        files.push_back(
            {{"file", entry.file.string()}, {"digest", entry.digest}, {"stamp", entry.stamp}});
    return json_text(
        {{"format", media_file.name}, {"version", media_file.newest_version}, {"files", files}});
}

Result<std::vector<MediaEntry>> parse_media(std::string_view text,
                                            const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    std::vector<MediaEntry> entries;
    if (accept_header(reader, media_file))
        if (const JsonValue* files = reader.require("files");
            files && reader.expect(*files, JsonValue::Kind::array))
            for (const JsonValue& item : files->children) {
                ObjectReader entry(item, file, problems);
                entries.push_back({entry.text("file"), entry.text("digest"), entry.text("stamp")});
            }
    if (!problems.empty())
        return fail(std::move(problems));
    return entries;
}
