#pragma once

#include "formats/pack/pack_format.h"
#include "formats/portable/media_names.h"
#include "lab/library/library.h"
#include "model/look/look.h"
#include "model/preset/preset.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Collects presets for a pack, with the sounds, pictures, scenes and drawings that they name.
class PackedPresets {
public:
    explicit PackedPresets(const Library& library) : m_library(library) {}

    /// `file` "": a line of text. `look`: the preset's look or stack. Fails if a file that the
    /// preset names is missing.
    Result<void> add(Preset preset, const std::filesystem::path& file, const Look& look);

    struct Files {
        std::vector<PackedPreset> presets;
        std::vector<std::filesystem::path> originals;        // of each preset; "": a line of text
        std::map<std::string, std::string> texts;            // by path in the pack
        std::map<std::string, std::filesystem::path> media;  // by path in the pack
    };
    /// The presets name their files in a folder next to them: `name` with a digest of the content.
    /// Equal folders therefore have equal names.
    Result<Files> finish(const std::string& name) const;

private:
    struct Collected {
        Preset preset;  // with paths in MediaNames
        std::filesystem::path file;
        std::string path;                // in the pack
        std::vector<std::string> media;  // paths in MediaNames
    };

    Result<void> collect_media(Collected& one, const std::filesystem::path& file);
    Result<void> add_shipped(const Preset& preset, const std::filesystem::path& file);
    std::string free_path(const std::string& look, const std::string& name) const;

    const Library& m_library;
    MediaNames m_names;
    std::vector<Collected> m_presets;
    std::map<std::string, std::filesystem::path> m_shipped_media;  // by path in the pack
};
