#include "lab/storage/media.h"

#include "base/file.h"
#include "base/text.h"
#include "io/files/atomic_file.h"
#include "io/files/file_digest.h"
#include "io/pictures/picture_sequence.h"
#include "io/video/video_file.h"
#include "lab/storage/file_stamp.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/generated_picture.h"
#include "signals/signal_table.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
bool has_extension(const fs::path& file, const std::vector<std::string>& extensions) {
    const std::string extension = to_lower(file.extension().string());
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

bool is_there(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error) || (is_sequence_name(file) && open_sequence(file));
}

// Videos and sequences have no digest, because they may be too large to read completely.
std::string digest_of_media(const fs::path& file) {
    if (is_video_file(file) || is_sequence_name(file))
        return {};
    return file_digest(file).value_or(std::string());
}
}  // namespace

std::string media_file_of(const Preset& preset) {
    if (!preset.source.empty()) {
        const auto source = parse_source(preset.source);
        return source && source->is_file() ? source->picture : std::string();
    }
    return preset.signal ? file_of(*preset.signal) : std::string();
}

Preset with_media_file(Preset preset, const std::string& file) {
    if (!preset.source.empty()) {
        SourceSpec source = *parse_source(preset.source);
        source.picture = file;
        preset.source = to_string(source);
        return preset;
    }
    if (const auto complete = completed(*preset.signal)) {
        const std::string& key = find_kind(complete->kind)->file_setting;
        preset.signal->settings.erase("");  // the unnamed first word, which was the file
        preset.signal->settings[key] = file;
    }
    return preset;
}

const std::vector<std::string>& sound_extensions() {
    static const std::vector<std::string> extensions{".wav", ".flac", ".ogg", ".oga",
                                                     ".mp3", ".aif",  ".aiff"};
    return extensions;
}

const std::vector<std::string>& picture_extensions() {
    static const std::vector<std::string> extensions{".png", ".jpg", ".jpeg",
                                                     ".exr", ".hdr", ".webp"};
    return extensions;
}

bool is_sound_file(const fs::path& file) {
    return has_extension(file, sound_extensions());
}

bool is_picture_file(const fs::path& file) {
    return has_extension(file, picture_extensions());
}

namespace {
// A live source is not a file.
fs::path listed_as(const fs::path& file) {
    return is_live(file.string()) ? file : fs::absolute(file).lexically_normal();
}
}  // namespace

std::vector<MediaEntry> RecentMedia::entries() const {
    if (!is_there(m_list))
        return {};
    const auto text = read_text(m_list);
    auto entries = text ? parse_media(*text, m_list) : fail(text.error());
    return entries ? std::move(*entries) : std::vector<MediaEntry>();
}

void RecentMedia::remember(const fs::path& file, const std::string& digest) const {
    constexpr std::size_t maximum = 100;
    std::vector<MediaEntry> list = entries();
    const MediaEntry entry{listed_as(file), digest, stamp_text(file)};
    if (!list.empty() && list.front() == entry)
        return;
    std::erase_if(list, [&entry](const MediaEntry& old) { return old.file == entry.file; });
    list.insert(list.begin(), entry);
    list.resize(std::min(list.size(), maximum));
    (void)write_atomically(m_list, media_to_json(list));
}

std::optional<fs::path> RecentMedia::find(const std::string& name,
                                          const std::string& digest) const {
    std::optional<fs::path> found;
    for (const MediaEntry& entry : entries()) {
        if (entry.file.filename() != fs::path(name).filename() || !is_there(entry.file))
            continue;
        if (!digest.empty() && entry.digest == digest)
            return entry.file;
        if (!found)
            found = entry.file;
    }
    return found;
}

bool RecentMedia::has(const fs::path& file) const {
    const std::vector<MediaEntry> all = entries();
    return std::ranges::find(all, listed_as(file), &MediaEntry::file) != all.end();
}

std::string RecentMedia::digest_of(const fs::path& file) const {
    for (const MediaEntry& entry : entries())
        if (entry.file == file)
            return entry.stamp == stamp_text(file) ? entry.digest : std::string();
    return {};
}

fs::path media_folder(const fs::path& preset_file) {
    return preset_file.empty() ? fs::current_path() : fs::absolute(preset_file).parent_path();
}

Preset with_found_media(Preset preset, const fs::path& folder, const RecentMedia& recent) {
    const std::string file = media_file_of(preset);
    if (file.empty())
        return preset;
    const fs::path sibling = fs::absolute(folder / file).lexically_normal();
    if (is_there(sibling))
        return with_media_file(std::move(preset), sibling.string());
    if (const auto found = recent.find(file, preset.media_digest))
        return with_media_file(std::move(preset), found->string());
    return preset;
}

bool names_file(const Look& look, const std::string& name, const Value& value) {
    const Parameter* parameter = find_parameter(look, name);
    return parameter && !value.path.empty() && !made_name(value.path) &&
           (parameter->control == Control::image || parameter->control == Control::sound);
}

Preset with_found_files(Preset preset, const Look& look, const fs::path& folder) {
    for (auto& [name, value] : preset.values)
        if (names_file(look, name, value))
            if (const fs::path sibling = fs::absolute(folder / value.path).lexically_normal();
                is_there(sibling))
                value.path = sibling.string();
    return preset;
}

Diagnostic other_media(const fs::path& file) {
    return {file, 0, "is not the file that the preset was saved with"};
}

Diagnostics compare_with_media(const Preset& preset) {
    const fs::path file = media_file_of(preset);
    if (file.empty() || preset.media_digest.empty())
        return {};
    const std::string digest = digest_of_media(file);
    if (digest.empty() || digest == preset.media_digest)
        return {};
    Diagnostic other = other_media(file);
    other.severity = Severity::warning;
    return {other};
}

namespace {
// The relative path of a file inside a folder; "": not inside.
fs::path path_inside(const fs::path& file, const fs::path& folder) {
    const fs::path inside = folder.empty() ? fs::path() : file.lexically_relative(folder);
    return inside.empty() || *inside.begin() == ".." ? fs::path() : inside;
}
}  // namespace

Preset with_portable_media(Preset preset, const fs::path& folder, const RecentMedia& recent) {
    for (auto& [name, value] : preset.values)
        if (const fs::path file = value.path; file.is_absolute() && is_there(file))
            if (const fs::path inside = path_inside(file, folder); !inside.empty())
                value.path = inside.string();
    if (media_file_of(preset).empty()) {
        preset.media_digest.clear();
        return preset;
    }
    const fs::path file = fs::absolute(media_file_of(preset)).lexically_normal();
    if (!is_there(file))
        return preset;  // was not found when opened: keep it as written
    preset.media_digest = recent.digest_of(file);
    if (preset.media_digest.empty())
        preset.media_digest = digest_of_media(file);
    const fs::path inside = path_inside(file, folder);
    return with_media_file(std::move(preset), (inside.empty() ? file.filename() : inside).string());
}
