#include "lab/golden/golden_item.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/json/json_document.h"
#include "formats/look_format.h"
#include "lab/golden/golden_name.h"
#include "lab/offline/corpus.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view preset_format_name = "afterglow-preset";

std::vector<fs::path> json_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, options, error), end;
         !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        if (entry->path().filename().string().starts_with('.')) {
            if (entry->is_directory(ignored))
                entry.disable_recursion_pending();
        } else if (to_lower(entry->path().extension().string()) == ".json" &&
                   entry->is_regular_file(ignored)) {
            files.push_back(entry->path());
        }
    }
    std::ranges::sort(files);
    return files;
}

// Text that isn't valid JSON: the look's name is searched, so that the picture keeps its name while
// the preset is broken.
std::optional<std::string> look_of_broken_preset(const std::string& text) {
    if (text.find(fmt::format("\"{}\"", preset_format_name)) == std::string::npos)
        return std::nullopt;
    const std::size_t key = text.find("\"look\"");
    const std::size_t colon = text.find(':', key);
    const std::size_t begin = text.find('"', colon);
    const std::size_t end =
        begin == std::string::npos ? std::string::npos : text.find('"', begin + 1);
    return key == std::string::npos || end == std::string::npos
               ? std::string()
               : text.substr(begin + 1, end - begin - 1);
}

// The look that a preset names, or ""; nullopt: the file is not a preset.
std::optional<std::string> look_of_preset(const fs::path& file) {
    const auto text = read_text(file);
    if (!text)
        return std::nullopt;
    const auto document = parse_json(*text, file);
    if (!document)
        return look_of_broken_preset(*text);
    const JsonValue* format = find_member(*document, "format");
    if (!format || format->text != preset_format_name)
        return std::nullopt;
    const JsonValue* look = find_member(*document, "look");
    return look ? look->text : std::string();
}

// A file of presets/LOOK/, as in the user's folder, is a preset whatever it contains.
std::optional<GoldenItem> preset_item(const fs::path& file) {
    const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
    const bool is_of_library = folder.parent_path().filename() == "presets";
    auto look = look_of_preset(file);
    if (!look && !is_of_library)
        return std::nullopt;
    if (!look || look->empty())
        look = folder.filename().string();
    return GoldenItem{{}, *look, file.stem().string(), file};
}

bool is_in_any(const fs::path& file, const std::set<fs::path>& folders) {
    for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
        if (folders.contains(folder))
            return true;
        if (folder == folder.parent_path())
            return false;
    }
}

void add_look(GoldenFolder& found, const std::string& id, const fs::path& path) {
    found.looks.push_back({id, path, false});
    found.items.push_back({{}, id, {}, path});
}

/// The three names that an item can have; later ones only if the earlier ones are not unique.
std::string name_at_stage(const GoldenItem& item, const fs::path& folder, int stage) {
    const fs::path relative = item.file.lexically_relative(folder);
    if (stage == 0)
        return golden_name(item.look, item.preset);
    const std::string name =
        golden_name(relative.parent_path().string() + '-' + item.look, item.preset);
    return stage == 1
               ? name
               : fmt::format("{}-{:08x}", name, digest_of(relative.generic_string()) & 0xFFFFFFFFU);
}

void give_names(std::vector<GoldenItem>& items, const fs::path& folder) {
    for (GoldenItem& item : items)
        item.name = name_at_stage(item, folder, 0);
    for (const int stage : {1, 2}) {
        std::map<std::string, int> uses;
        for (const GoldenItem& item : items)
            ++uses[item.name];
        for (GoldenItem& item : items)
            if (uses[item.name] > 1)
                item.name = name_at_stage(item, folder, stage);
    }
}
}  // namespace

Result<GoldenFolder> read_golden_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error))
        return fail(
            {folder, 0, fs::exists(folder, error) ? "is not a folder" : "folder not found"});
    GoldenFolder found;
    std::set<fs::path> closed;  // folders whose shaders belong to one look
    for (const fs::path& file : json_files(folder)) {
        const bool is_look = file.filename() == "look.json";
        if (is_look)
            add_look(found, look_id_at(file), file.parent_path());
        if (is_look || file.filename() == "portable.json")
            closed.insert(file.parent_path());
        else if (auto preset = preset_item(file))
            found.items.push_back(std::move(*preset));
    }
    for (const fs::path& file : corpus_files(folder, {}))
        if (!is_in_any(file, closed))
            add_look(found, look_id_at(file), file);
    if (found.items.empty())
        return fail({folder, 0, "the folder contains no looks and no presets"});
    give_names(found.items, folder);
    std::ranges::sort(found.items, {}, &GoldenItem::name);
    return found;
}
