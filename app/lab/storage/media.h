#pragma once

#include "formats/preset/media_format.h"
#include "lab/storage/roots.h"
#include "model/preset/preset.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The extensions of sounds and pictures: ".wav".
const std::vector<std::string>& sound_extensions();
const std::vector<std::string>& picture_extensions();
/// Whether the file name has the extension of a sound.
bool is_sound_file(const std::filesystem::path& file);
/// Whether the file name has the extension of a picture.
bool is_picture_file(const std::filesystem::path& file);

/// The user's recently opened sounds, pictures and live sources, stored between sessions. A preset
/// names its file without a folder, so that it can be shared. This list finds the file again.
class RecentMedia {
public:
    explicit RecentMedia(const Roots& roots) : m_list(roots.state / "media.json") {}

    /// Moves a file to the front and writes the list. The list is optional, so write
    /// errors are ignored.
    void remember(const std::filesystem::path& file, const std::string& digest) const;
    /// The latest existing file with this name, preferably with this digest.
    std::optional<std::filesystem::path> find(const std::string& name,
                                              const std::string& digest) const;
    bool has(const std::filesystem::path& file) const;
    /// The stored digest; "": the file is unknown or has changed since.
    std::string digest_of(const std::filesystem::path& file) const;

private:
    std::vector<MediaEntry> entries() const;

    std::filesystem::path m_list;
};

/// The file that a preset's signal or source names, as written; "": none.
std::string media_file_of(const Preset& preset);
/// The preset with another path of this file.
Preset with_media_file(Preset preset, const std::string& file);

/// The folder in which a preset's files are searched first: that of the preset file, or without a
/// file the working directory.
std::filesystem::path media_folder(const std::filesystem::path& preset_file);

/// The preset with the full path of its signal's or source's file. The file is searched in
/// `folder`, then among the recent files. If it is not found, the path is unchanged.
Preset with_found_media(Preset preset, const std::filesystem::path& folder,
                        const RecentMedia& recent);

/// Whether a value is the path of a file, not numbers or a generated picture.
bool names_file(const Look& look, const std::string& parameter, const Value& value);

/// The preset with full paths for the files of its values that are in `folder`.
Preset with_found_files(Preset preset, const Look& look, const std::filesystem::path& folder);

/// The diagnostic for a file that differs from the one the preset was saved with.
Diagnostic other_media(const std::filesystem::path& file);

/// A warning if the preset's file exists but differs from the one it was saved with.
Diagnostics compare_with_media(const Preset& preset);

/// The preset for saving in `folder` ("": as a line of text). Its file gets a path relative to the
/// folder, or only its name, and the digest. Files of its values outside the folder keep their full
/// path.
Preset with_portable_media(Preset preset, const std::filesystem::path& folder,
                           const RecentMedia& recent);
