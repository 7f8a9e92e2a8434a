#include "lab/library/named_preset.h"

#include "base/text.h"
#include "formats/preset/preset_format.h"
#include "lab/library/open.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view default_name = "default";

bool is_name_character(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

// Other names could be paths out of the library.
bool is_listed(const Library& library, const std::string& look) {
    const std::vector<std::string> stacks = library.stacks();
    return library.find_look(look) || std::ranges::find(stacks, look) != stacks.end();
}

std::optional<fs::path> find_in_look(const Library& library, const std::string& look,
                                     const std::string& name) {
    const std::string wanted = normalized_name(name);
    const std::vector<PresetEntry> presets = library.presets(look);
    for (const PresetEntry& entry : presets)
        if (entry.id == name || normalized_name(entry.name) == wanted)
            return entry.file;
    for (const PresetEntry& entry : presets)
        if (const auto preset = load_preset(entry.file);
            preset && normalized_name(preset->name) == wanted)
            return entry.file;
    return std::nullopt;
}

std::string similar_name(const Library& library, const std::string& look, const std::string& name) {
    std::vector<std::string> names;
    for (const PresetEntry& entry : library.presets(look)) {
        if (const auto preset = load_preset(entry.file); preset && !preset->name.empty())
            names.push_back(preset->name);
        names.push_back(entry.name);
    }
    return did_you_mean(name, names);
}
}  // namespace

std::string normalized_name(std::string_view name) {
    std::string normalized;
    for (const char c : to_lower(name))
        if (is_name_character(c))
            normalized += c;
        else if (!normalized.empty() && normalized.back() != '-')
            normalized += '-';
    if (!normalized.empty() && normalized.back() == '-')
        normalized.pop_back();
    return normalized;
}

Result<fs::path> find_named_preset(const Library& library, const std::string& look,
                                   const std::string& name) {
    if (const auto found = find_in_look(library, look, name))
        return *found;
    if (normalized_name(name) == default_name)
        return fs::path();
    const std::size_t slash = name.find('/');
    if (slash != std::string::npos && is_listed(library, name.substr(0, slash)))
        if (const auto found = find_in_look(library, name.substr(0, slash), name.substr(slash + 1)))
            return *found;
    return fail(
        {{},
         0,
         fmt::format("'{}' has no preset '{}'{}", look, name, similar_name(library, look, name))});
}

std::string reference_to_preset(const Library& library, const std::string& look,
                                const fs::path& file, const std::string& name) {
    if (const auto found = resolve_preset(name, look, library);
        !name.empty() && found && found->preset_file == file)
        return name;
    for (const PresetEntry& entry : library.presets(look))
        if (entry.file == file)
            return entry.id.empty() ? entry.name : entry.id;
    return file.string();
}
