#include "lab/open.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/json_document.h"
#include "formats/preset_format.h"
#include "formats/share_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
std::vector<std::string> look_ids(const Library& library) {
    std::vector<std::string> ids;
    for (const LookEntry& look : library.looks())
        ids.push_back(look.id);
    return ids;
}

// A .json is told by its "format" key; one that cannot be read by its name.
bool is_look_manifest(const fs::path& file) {
    if (const auto text = read_text(file))
        if (const auto document = parse_json(*text, file))
            if (const JsonValue* format = find_member(*document, "format"))
                return format->text == "afterglow-look";
    return file.filename() == "look.json";
}

Result<OpenRequest> request_of_preset(Preset preset, fs::path file, const Library& library) {
    const auto look = library.find_look(preset.look);
    if (!look)
        return fail({file, 0,
                     fmt::format("this preset is for the look '{}', which is not here{}",
                                 preset.look, did_you_mean(preset.look, look_ids(library)))});
    return OpenRequest{look->folder, std::move(preset), std::move(file)};
}

Result<OpenRequest> request_of_file(const fs::path& file, const Library& library) {
    const std::string extension = to_lower(file.extension().string());
    if (extension == ".png" || (extension == ".json" && !is_look_manifest(file))) {
        auto preset = load_preset(file);
        return preset ? request_of_preset(std::move(*preset), file, library) : fail(preset.error());
    }
    if (extension == ".json")
        return OpenRequest{file, {}, {}};
    return fail(
        {file, 0, "is neither a look's folder, a look.json, a preset nor a PNG that holds one"});
}
}  // namespace

Result<OpenRequest> resolve(const std::string& argument, const Library& library) {
    if (argument.starts_with("afterglow:")) {
        auto preset = parse_share_line(argument);
        return preset ? request_of_preset(std::move(*preset), {}, library) : fail(preset.error());
    }
    std::error_code error;
    const fs::path path(argument);
    const bool is_path = argument.find('/') != std::string::npos || path.has_extension();
    if (const auto look = library.find_look(argument); look && !is_path)
        return OpenRequest{look->folder, {}, {}};
    if (fs::is_directory(path, error))
        return OpenRequest{path, {}, {}};
    if (fs::exists(path, error))
        return request_of_file(path, library);
    if (is_path)
        return fail({path, 0, "there is no such file or folder"});
    return fail({{},
                 0,
                 fmt::format("there is no look called '{}'{}", argument,
                             did_you_mean(argument, look_ids(library)))});
}

Result<OpenRequest> resolve_preset(const std::string& argument, const std::string& look,
                                   const Library& library) {
    if (const auto entry = library.find_preset(look, argument)) {
        auto preset = load_preset(entry->file);
        return preset ? request_of_preset(std::move(*preset), entry->file, library)
                      : fail(preset.error());
    }
    std::error_code error;
    if (!argument.starts_with("afterglow:") && !fs::exists(argument, error)) {
        std::vector<std::string> names;
        for (const PresetEntry& entry : library.presets(look))
            names.push_back(entry.name);
        return fail({{},
                     0,
                     fmt::format("'{}' has no preset called '{}', and there is no such file{}",
                                 look, argument, did_you_mean(argument, names))});
    }
    auto request = resolve(argument, library);
    if (request && !request->preset)
        return fail({argument, 0, "is a look, not a preset"});
    return request;
}

LoadedLook load_requested(const OpenRequest& request, const Library& library) {
    return load_look(request.look, library.roots().shared_includes());
}
