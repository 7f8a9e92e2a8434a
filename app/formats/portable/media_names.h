#pragma once

#include "base/diagnostic.h"
#include "formats/portable/exact_picture.h"

#include <filesystem>
#include <map>
#include <string>

/// A name for a file of a portable look: letters, digits, '.', '-' and '_'. Other characters become
/// '-'; never empty and never hidden.
std::string safe_name(const std::string& name);

/// The files that a portable look copies, each with a path of its own below "media".
class MediaNames {
public:
    /// The path of a file's copy. The same file has one copy.
    std::string add(const std::filesystem::path& file);
    /// A source whose files are copies: "media/game.png,fit=whole". All pictures of a numbered
    /// sequence are added. A generated picture ("pattern:smpte", "solid:sky") becomes a file with
    /// the picture at time 0.
    Result<std::string> add_source(const std::string& source);
    /// The same without settings.
    Result<std::string> add_generated(const std::string& name);
    /// The path of a signal's file. A scene gets a folder with the files of its items, which are
    /// next to it.
    std::string add_signal(const std::filesystem::path& file);
    const std::map<std::string, std::filesystem::path>& files() const { return m_files; }
    /// Generated pictures, by path.
    const std::map<std::string, PictureFile>& generated() const { return m_generated; }

private:
    std::string add_sequence(const std::filesystem::path& names);

    std::map<std::string, std::filesystem::path> m_files;  // by path of the copy
    std::map<std::string, PictureFile> m_generated;
    std::map<std::string, std::string> m_generated_paths;  // by name
};
