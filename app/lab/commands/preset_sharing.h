#pragma once

#include "lab/commands/content_commands.h"
#include "lab/frame/workspace.h"
#include "lab/reload/look_loader.h"

#include <filesystem>
#include <string>

/// Presets as lines of text, as RetroArch files, and as files that other programs change.
class PresetSharing {
public:
    PresetSharing(Workspace& work, LookLoader& loader, ContentCommands& content)
        : m_work(work), m_loader(loader), m_content(content) {}

    /// The document as one line of text; "": no look is open.
    std::string line() const;
    void paste(const std::string& line);
    /// Whether a single RetroArch look is open.
    bool can_save_slang() const;
    /// Writes a .slangp that refers to the open file and has the changed values.
    void save_slang(const std::filesystem::path& file);
    /// Call when the file of the open preset changed: applies its values unless there are unsaved
    /// changes.
    void file_changed(const std::filesystem::path& file);

private:
    void apply_fitted(const Preset& preset, const std::filesystem::path& file, const char* step);

    Workspace& m_work;
    LookLoader& m_loader;
    ContentCommands& m_content;
};
