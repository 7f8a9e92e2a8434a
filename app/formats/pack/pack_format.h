#pragma once

#include "base/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

/// The extension of packs, and the names of their parts.
inline constexpr std::string_view pack_extension = ".afterglow";
inline constexpr const char* pack_file = "pack.json";
inline constexpr const char* thumbnail_folder = "thumbnails";

/// A look in a pack.
struct PackedLook {
    std::string id;  // as presets name it
    std::string name;
    std::string author;
    std::string license;
    std::string folder;          // "shaders/glow"
    std::string file = {};       // within the folder, for a look of another program: "crt/a.slangp"
    bool is_shipped = false;     // an unchanged look of Afterglow
    std::string thumbnail = {};  // "thumbnails/glow.png"; "": none

    bool operator==(const PackedLook&) const = default;
};

/// A preset in a pack.
struct PackedPreset {
    std::string look;  // id, or "a+b"
    std::string name;
    std::string author;
    std::string file;            // "presets/glow/warm.json"
    std::string thumbnail = {};  // "": none

    bool operator==(const PackedPreset&) const = default;
};

/// The licence and the comments about it of a shader or an include.
struct PackedSource {
    std::string file;
    std::string license;  // SPDX identifier, "see comments", or "not stated"
    std::string notice;   // the comments

    bool operator==(const PackedSource&) const = default;
};

/// The table of contents of a pack: its file pack.json.
struct PackManifest {
    std::string name;
    std::vector<PackedLook> looks;
    std::vector<PackedPreset> presets;
    std::vector<PackedSource> sources;

    bool operator==(const PackManifest&) const = default;
};

/// Whether a file name has the extension of packs.
bool is_pack(const std::filesystem::path& file);

std::string pack_to_json(const PackManifest& manifest);
/// Errors, each with its line: unknown keys, a newer version, paths outside the folders of a pack,
/// ids that are not one folder name.
Result<PackManifest> parse_pack(std::string_view text, const std::filesystem::path& file);
