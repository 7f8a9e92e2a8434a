#include "formats/pack/pack_format.h"

#include "base/text.h"
#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
constexpr FileFormat pack_format{"afterglow-pack", 1};

Json look_json(const PackedLook& look) {
    Json json{{"id", look.id},
              {"name", look.name},
              {"author", look.author},
              {"license", look.license},
              {"folder", look.folder}};
    if (!look.file.empty())
        json["file"] = look.file;
    if (look.is_shipped)
        json["shipped"] = true;
    if (!look.thumbnail.empty())
        json["thumbnail"] = look.thumbnail;
    return json;
}

Json preset_json(const PackedPreset& preset) {
    Json json{{"look", preset.look},
              {"name", preset.name},
              {"author", preset.author},
              {"file", preset.file}};
    if (!preset.thumbnail.empty())
        json["thumbnail"] = preset.thumbnail;
    return json;
}

// A single name that is not hidden: nothing in it leads to another folder.
bool is_single_name(std::string_view text) {
    return !text.empty() && text.front() != '.' && text.find('/') == text.npos &&
           text.find('\\') == text.npos;
}

// Whether a path consists of such names and begins with a folder.
bool is_path_below(std::string_view path, std::string_view folder) {
    const auto names = split(path, '/');
    return names.size() >= 2 && (folder.empty() || names.front() == folder) &&
           std::ranges::all_of(names, is_single_name);
}

// Reads the texts of one member of a list.
class ItemReader {
public:
    ItemReader(const JsonValue& value, const fs::path& file, Diagnostics& problems)
        : m_reader(value, file, problems) {}
    ~ItemReader() { m_reader.report_unknown_keys(); }
    ItemReader(const ItemReader&) = delete;
    ItemReader& operator=(const ItemReader&) = delete;

    ObjectReader& reader() { return m_reader; }
    std::string name(const char* key) {
        return checked(key, is_single_name, "must be one name without '/' that is not hidden");
    }
    std::string path(const char* key, std::string_view folder) {
        return checked(
            key, [&](std::string_view text) { return is_path_below(text, folder); },
            folder.empty() ? "must be a path inside the pack"
                           : fmt::format("must be a path below {}/", folder));
    }
    std::string path_if_any(const char* key, std::string_view folder) {
        return m_reader.find(key) ? path(key, folder) : std::string();
    }

private:
    template <class Check>
    std::string checked(const char* key, const Check& is_good, const std::string& rule) {
        const JsonValue* value = m_reader.require(key);
        std::string text = m_reader.text(key);
        if (value && !is_good(text))
            m_reader.problem(*value, fmt::format("'{}' {}, got '{}'", key, rule, text));
        return text;
    }

    ObjectReader m_reader;
};

template <class Item, class Read>
std::vector<Item> read_list(ObjectReader& reader, const char* key, const Read& read) {
    std::vector<Item> items;
    const JsonValue* list = reader.find(key);
    if (list && reader.expect(*list, JsonValue::Kind::array))
        for (const JsonValue& value : list->children) {
            ItemReader item(value, reader.file(), reader.problems());
            items.push_back(read(item));
        }
    return items;
}

PackedLook read_packed_look(ItemReader& item) {
    PackedLook look;
    look.id = item.name("id");
    look.name = item.reader().text("name");
    look.author = item.reader().text("author");
    look.license = item.reader().text("license");
    look.folder = item.path("folder", "shaders");
    look.is_shipped = item.reader().boolean("shipped", false);
    look.thumbnail = item.path_if_any("thumbnail", thumbnail_folder);
    if (const JsonValue* file = item.reader().find("file")) {
        look.file = item.reader().text("file");
        if (!is_path_below("x/" + look.file, "x"))
            item.reader().problem(*file, "'file' must be a path inside the look's folder");
    }
    return look;
}

PackedPreset read_preset(ItemReader& item) {
    return {item.name("look"), item.reader().text("name"), item.reader().text("author"),
            item.path("file", "presets"), item.path_if_any("thumbnail", thumbnail_folder)};
}

PackedSource read_source(ItemReader& item) {
    return {item.path("file", ""), item.reader().text("license"), item.reader().text("notice")};
}
}  // namespace

bool is_pack(const fs::path& file) {
    return to_lower(file.extension().string()) == pack_extension;
}

std::string pack_to_json(const PackManifest& manifest) {
    Json looks = Json::array();
    for (const PackedLook& look : manifest.looks)
        looks.push_back(look_json(look));
    Json presets = Json::array();
    for (const PackedPreset& preset : manifest.presets)
        presets.push_back(preset_json(preset));
    Json sources = Json::array();
    for (const PackedSource& source : manifest.sources)
        sources.push_back(
            {{"file", source.file}, {"license", source.license}, {"notice", source.notice}});
    return json_text({{"format", pack_format.name},
                      {"version", pack_format.newest_version},
                      {"name", manifest.name},
                      {"looks", std::move(looks)},
                      {"presets", std::move(presets)},
                      {"sources", std::move(sources)}});
}

Result<PackManifest> parse_pack(std::string_view text, const fs::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    PackManifest manifest;
    if (accept_header(reader, pack_format)) {
        manifest.name = reader.text("name");
        manifest.looks = read_list<PackedLook>(reader, "looks", read_packed_look);
        manifest.presets = read_list<PackedPreset>(reader, "presets", read_preset);
        manifest.sources = read_list<PackedSource>(reader, "sources", read_source);
        reader.report_unknown_keys();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return manifest;
}
