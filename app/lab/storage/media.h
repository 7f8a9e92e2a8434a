#pragma once

#include "formats/preset/media_format.h"
#include "lab/storage/roots.h"
#include "model/preset/preset.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Whether a file's name says that it is a sound.
bool is_sound_file(const std::filesystem::path& file);
/// Whether a file's name says that it is a picture.
bool is_picture_file(const std::filesystem::path& file);

/// The person's own sounds and pictures that were opened lately, kept between uses. A preset names
/// such a file by its name alone, so that it can be shared; here it is found again.
class RecentMedia {
public:
    explicit RecentMedia(const Roots& roots) : m_list(roots.state / "media.json") {}

    /// Puts a file in front and writes the list. The list is a help only: where it cannot be
    /// written nothing else stops.
    void remember(const std::filesystem::path& file, const std::string& digest) const;
    /// The latest existing file of that name; one with that digest goes first.
    std::optional<std::filesystem::path> find(const std::string& name,
                                              const std::string& digest) const;
    bool has(const std::filesystem::path& file) const;
    /// As remembered; "" when it is not, or when the file has changed since.
    std::string digest_of(const std::filesystem::path& file) const;

private:
    std::vector<MediaEntry> entries() const;

    std::filesystem::path m_list;
};

/// Where a preset's own files are looked for first: beside it; where it is no file, in the folder
/// that the program was started in.
std::filesystem::path media_folder(const std::filesystem::path& preset_file);

/// The preset with the full path of the file that its signal or source names: looked for beside the
/// preset (in `folder`), then among the recent ones. A file that is nowhere stays as it is written.
Preset with_found_media(Preset preset, const std::filesystem::path& folder,
                        const RecentMedia& recent);

/// Whether a value of the look is the path of a file, rather than numbers or a made picture.
bool names_file(const Look& look, const std::string& parameter, const Value& value);

/// The preset with full paths for those files of its values that are in `folder`.
Preset with_found_files(Preset preset, const Look& look, const std::filesystem::path& folder);

/// A file that is not the one that a preset was made with.
Diagnostic other_media(const std::filesystem::path& file);

/// A warning when the file that it names is there, but is not the one that it was made with.
Diagnostics compare_with_media(const Preset& preset);

/// The preset as it is saved into `folder` ("": a line of text): its file by a path within the
/// folder, or by its name alone, with the digest. Files that its values choose keep their full path
/// where they lie outside.
Preset with_portable_media(Preset preset, const std::filesystem::path& folder,
                           const RecentMedia& recent);
