#include "lab/packs/packed_presets.h"

#include "base/file.h"
#include "base/text.h"
#include "formats/preset/preset_format.h"
#include "formats/preset/preset_update.h"
#include "formats/scene/scene_file.h"
#include "io/files/file_digest.h"
#include "io/pictures/picture_sequence.h"
#include "lab/storage/media.h"
#include "lab/storage/name_check.h"
#include "model/picture/source_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view media_prefix = "media/";  // of MediaNames

Diagnostic missing_file(const Preset& preset, const fs::path& preset_file, const fs::path& file) {
    return {
        preset_file, 0,
        fmt::format("the preset '{}' names {}, which was not found. Open the preset, choose the "
                    "file, and save.",
                    preset.name, file.string())};
}

// "x" or "x/" of "media/x" and "media/x/y": a file, or the folder of a sequence or scene.
std::string entry_of(const std::string& path) {
    const std::size_t end = path.find('/', media_prefix.size());
    return path.substr(0, end == path.npos ? end : end + 1);
}

bool belongs_to(const std::string& path, const std::string& entry) {
    return entry.ends_with('/') ? path.starts_with(entry) : path == entry;
}

Result<std::string> digest_of_files(const std::map<std::string, fs::path>& files) {
    std::string all;
    for (const auto& [path, file] : files) {
        const auto digest = file_digest(file);
        if (!digest)
            return fail(digest.error());
        all += fmt::format("{} {}\n", path, *digest);
    }
    return fmt::format("{:08x}", digest_of(all) & 0xFFFFFFFFU);
}

// The text of a preset file, with the paths of the copies.
std::string text_of(const Preset& preset, const fs::path& file) {
    const auto text =
        to_lower(file.extension().string()) == ".json" ? read_text(file) : Result<std::string>();
    return text ? updated_preset_text(*text, preset, nullptr) : preset_to_json(preset);
}
}  // namespace

std::string PackedPresets::free_path(const std::string& look, const std::string& name) const {
    const std::string valid = valid_preset_name(name);
    const std::string stem = valid.empty() ? "preset" : valid;
    std::string path = fmt::format("presets/{}/{}.json", look, stem);
    const auto is_taken = [&](const Collected& other) {
        return to_lower(other.path) == to_lower(path);
    };
    for (int number = 2; std::ranges::any_of(m_presets, is_taken); ++number)
        path = fmt::format("presets/{}/{}-{}.json", look, stem, number);
    return path;
}

Result<void> PackedPresets::collect_media(Collected& one, const fs::path& file) {
    std::error_code error;
    const bool is_sequence = is_sequence_name(file);
    if (!is_sequence && !fs::is_regular_file(file, error))
        return fail(missing_file(one.preset, one.file, file));
    std::string copy;
    if (is_sequence) {
        auto source = m_names.add_source(file.string());
        if (!source)
            return fail(source.error());
        copy = std::move(*source);
    } else {
        copy = m_names.add_signal(file);
    }
    one.media.push_back(entry_of(copy));
    one.preset = with_media_file(std::move(one.preset), copy);
    return {};
}

// A shipped preset keeps its text, so that it is recognised where Afterglow is installed.
Result<void> PackedPresets::add_shipped(const Preset& preset, const fs::path& file) {
    Collected one{preset, file, {}, {}};
    one.path = free_path(preset.look, file.stem().string());
    if (const fs::path named = media_file_of(preset); !named.empty()) {
        std::vector<fs::path> names{named};
        if (is_scene_file(named))
            for (const fs::path& other : files_of_scene(file.parent_path() / named))
                names.push_back(named.parent_path() / other);
        for (const fs::path& name : names)
            m_shipped_media.emplace(
                fmt::format("presets/{}/{}", preset.look, name.generic_string()),
                file.parent_path() / name);
    }
    m_presets.push_back(std::move(one));
    return {};
}

Result<void> PackedPresets::add(Preset preset, const fs::path& file, const Look& look) {
    if (!file.empty() && m_library.is_shipped(file))
        return add_shipped(preset, file);
    const fs::path folder = media_folder(file);
    Collected one{with_found_files(
                      with_found_media(std::move(preset), folder, RecentMedia(m_library.roots())),
                      look, folder),
                  file,
                  {},
                  {}};
    one.path = free_path(one.preset.look, file.empty() ? one.preset.name : file.stem().string());
    if (const fs::path named = media_file_of(one.preset); !named.empty())
        if (auto collected = collect_media(one, fs::absolute(named).lexically_normal()); !collected)
            return collected;
    for (auto& [name, value] : one.preset.values) {
        if (!names_file(look, name, value))
            continue;
        std::error_code error;
        if (!fs::is_regular_file(value.path, error))
            return fail(missing_file(one.preset, file, value.path));
        value.path = m_names.add(fs::absolute(value.path).lexically_normal());
        one.media.push_back(entry_of(value.path));
    }
    m_presets.push_back(std::move(one));
    return {};
}

Result<PackedPresets::Files> PackedPresets::finish(const std::string& name) const {
    const auto digest = digest_of_files(m_names.files());
    if (!digest)
        return fail(digest.error());
    const std::string folder = fmt::format("{}-{}/", safe_name(name), *digest);
    const auto moved = [&](const std::string& path) {
        return path.starts_with(media_prefix) ? folder + path.substr(media_prefix.size()) : path;
    };
    Files files;
    files.media = m_shipped_media;
    for (const Collected& one : m_presets) {
        Preset preset = one.preset;
        if (const std::string file = media_file_of(preset); !file.empty())
            preset = with_media_file(std::move(preset), moved(file));
        for (auto& [parameter, value] : preset.values)
            value.path = moved(value.path);
        for (const std::string& entry : one.media)
            for (const auto& [path, file] : m_names.files())
                if (belongs_to(path, entry))
                    files.media.emplace(fmt::format("presets/{}/{}", preset.look, moved(path)),
                                        file);
        files.texts.emplace(one.path, text_of(preset, one.file));
        files.presets.push_back({preset.look, preset.name, preset.author, one.path});
        files.originals.push_back(one.file);
    }
    return files;
}
