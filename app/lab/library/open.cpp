#include "lab/library/open.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/foreign_format.h"
#include "formats/json/json_document.h"
#include "formats/pack/pack_format.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/share_line.h"
#include "formats/shadertoy/shadertoy_files.h"
#include "formats/stack/stack_format.h"
#include "glsl/cache/check_cache.h"
#include "lab/storage/media.h"
#include "model/look/stack_size.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
std::vector<std::string> known_looks(const Library& library) {
    std::vector<std::string> ids;
    for (const LookEntry& look : library.looks())
        ids.push_back(look.id);
    return ids;
}

// A .json look has a "format" key. If the file cannot be parsed, its name decides.
bool is_look_manifest(const fs::path& file) {
    if (const auto text = read_text(file))
        if (const auto document = parse_json(*text, file))
            if (const JsonValue* format = find_member(*document, "format"))
                return format->text == "afterglow-look";
    return file.filename() == "look.json";
}

// A foreign look is searched next to the preset, then among the recent files.
std::optional<StackPart> foreign_part(const std::string& id, const fs::path& preset_file,
                                      const Library& library) {
    const std::string name = foreign_file_name(id);
    if (!is_foreign_look(name))
        return std::nullopt;
    std::error_code error;
    const fs::path sibling = media_folder(preset_file) / name;
    if (fs::is_regular_file(sibling, error))
        return StackPart{id, sibling, {}};
    const auto found = RecentMedia(library.roots()).find(name, {});
    return found ? std::optional(StackPart{id, *found, {}}) : std::nullopt;
}

std::optional<StackPart> part_of_preset(const std::string& id, const fs::path& preset_file,
                                        const Library& library) {
    if (const auto look = library.find_look(id))
        return StackPart{id, look->folder, {}};
    return foreign_part(id, preset_file, library);
}

Result<OpenRequest> request_of_preset(Preset preset, fs::path file, const Library& library) {
    Stack stack;
    for (const std::string& id : look_ids(preset.look)) {
        auto part = part_of_preset(id, file, library);
        if (!part)
            return fail({file, 0,
                         fmt::format("this preset needs the look '{}', which was not found{}", id,
                                     did_you_mean(id, known_looks(library)))});
        part->tag = free_tag(stack, id);
        stack.push_back(std::move(*part));
    }
    stack = with_bypass(std::move(stack), preset.bypass);
    if (!preset.source.empty())
        stack = with_driver(std::move(stack), true);
    if (is_picture_driven(stack) && preset.signal)
        return fail({file, 0,
                     fmt::format("a signal or a picture drives '{}', but not both. Remove 'signal' "
                                 "or 'source'.",
                                 preset.look)});
    const fs::path first = stack.front().path;
    return OpenRequest{first, std::move(preset), std::move(file), std::move(stack)};
}

// Browsers save the HTML page of a site instead of the raw file.
bool is_web_page(const fs::path& file) {
    constexpr std::size_t enough = 512;
    const auto start = read_start(file, enough);
    const std::string text = start ? to_lower(trim(*start)) : std::string();
    return text.starts_with("<!doctype html") || text.starts_with("<html");
}

Result<OpenRequest> request_of_file(const fs::path& file, const Library& library) {
    const std::string extension = to_lower(file.extension().string());
    if (extension != ".json" && is_web_page(file))
        return fail({file, 1, "is a web page, not a shader. Download the raw file instead."});
    const bool is_foreign = is_foreign_look(file);
    if (extension == ".png" || (extension == ".json" && !is_foreign && !is_look_manifest(file))) {
        auto preset = load_preset(file);
        return preset ? request_of_preset(std::move(*preset), file, library) : fail(preset.error());
    }
    if (extension == ".json" || is_foreign)
        return OpenRequest{file, {}, {}};
    return fail({file, 0,
                 fmt::format("is not a look, preset, picture or sound. Afterglow opens looks of "
                             "other programs: {}.",
                             foreign_labels())});
}

// A native look, or a Shadertoy look with one file per pass.
OpenRequest request_of_folder(const fs::path& folder) {
    std::error_code error;
    const auto image =
        fs::exists(folder / "look.json", error) ? std::nullopt : find_shadertoy_image(folder);
    return {image.value_or(folder), {}, {}};
}

// A look name takes precedence over a folder, as for a single look.
Result<StackPart> resolve_part(const std::string& argument, const Library& library) {
    const fs::path path(argument);
    std::error_code error;
    if (argument.empty())
        return fail({{}, 0, "write a stack as LOOK+LOOK, without spaces"});
    if (const auto look = library.find_look(argument))
        return StackPart{look->id, look->folder, {}};
    if (fs::is_directory(path, error) || path.filename() == "look.json" ||
        (fs::exists(path, error) && is_foreign_look(path)))
        return StackPart{{}, path, {}};
    if (fs::exists(path, error))
        return fail({path, 0, "is not a look. A stack can only contain looks."});
    return fail({{},
                 0,
                 fmt::format("there is no look called '{}'{}", argument,
                             did_you_mean(argument, known_looks(library)))});
}

Result<OpenRequest> resolve_stack(const std::string& argument, const Library& library) {
    if (std::string fault = fault_of_stack_size(argument); !fault.empty())
        return fail({{}, 0, std::move(fault)});
    Stack stack;
    Diagnostics problems;
    for (const std::string& piece : look_ids(argument)) {
        auto part = resolve_part(piece, library);
        if (part)
            stack.push_back(std::move(*part));
        else
            problems.insert(problems.end(), part.error().begin(), part.error().end());
    }
    if (!problems.empty())
        return fail(std::move(problems));
    const fs::path first = stack.front().path;
    return OpenRequest{first, {}, {}, std::move(stack)};
}
}  // namespace

Stack stack_of(const OpenRequest& request) {
    return request.stack.empty() ? Stack{{{}, request.look, {}}} : request.stack;
}

Values values_of(const OpenRequest& request) {
    Values values = request.constants;
    if (request.preset)
        values.insert(request.preset->values.begin(), request.preset->values.end());
    return values;
}

std::string name_of(const OpenRequest& request) {
    std::string name;
    for (const StackPart& part : stack_of(request)) {
        const fs::path& part_path = part.path;
        const bool is_in_folder = part_path.filename() == "look.json" || !part_path.has_filename();
        const fs::path named = is_in_folder ? part_path.parent_path() : part_path;
        name += (name.empty() ? "" : "+") + named.filename().string();
    }
    return name;
}

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
        return request_of_folder(path);
    if (fs::exists(path, error))
        return request_of_file(path, library);
    if (argument.find('+') != std::string::npos)
        return resolve_stack(argument, library);
    if (const auto look = library.find_look(argument))  // "glow.slangp" in the library
        return OpenRequest{look->folder, {}, {}};
    if (is_path)
        return fail({path, 0, "file or folder not found"});
    return fail({{},
                 0,
                 fmt::format("there is no look called '{}'{}", argument,
                             did_you_mean(argument, known_looks(library)))});
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
        for (const PresetEntry& entry : library.presets(look)) {
            auto preset = load_preset(entry.file);  // by its displayed name
            if (preset && to_lower(preset->name) == to_lower(argument))
                return request_of_preset(std::move(*preset), entry.file, library);
            if (preset && !preset->name.empty())
                names.push_back(preset->name);
            names.push_back(entry.name);
        }
        return fail({{},
                     0,
                     fmt::format("'{}' has no preset or file called '{}'{}", look, argument,
                                 did_you_mean(argument, names))});
    }
    auto request = resolve(argument, library);
    if (request && !request->preset)
        return fail({argument, 0, "is a look, not a preset"});
    return request;
}

LoadedLook load_requested(const OpenRequest& request, const Library& library,
                          const LoadOptions& help) {
    const Values values = values_of(request);
    CheckCache checks(nullptr, library.roots().shader_limits);
    return load_stack(stack_of(request), library.roots().include_folders(),
                      {help.cache ? help.cache : &checks, help.progress, &values});
}

std::vector<std::string> look_extensions() {
    std::vector<std::string> extensions = foreign_extensions();  // .json and .glsl are ours, too
    extensions.emplace_back(pack_extension);
    return extensions;
}

std::string other_programs() {
    return foreign_labels();
}
