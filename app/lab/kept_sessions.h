#pragma once

#include "formats/session_format.h"
#include "lab/roots.h"

#include <filesystem>
#include <string>
#include <vector>

/// Unsaved changes whose place another look took, in a file each: the latest dozen.
class KeptSessions {
public:
    explicit KeptSessions(const Roots& roots);

    /// The latest first.
    const std::vector<std::filesystem::path>& files() const { return m_files; }
    /// Keeps a session that has unsaved changes, the same but once. True where there were some.
    Result<bool> keep(const Session& session);
    /// What a file holds; a damaged one stays where it is.
    static Result<Session> read(const std::filesystem::path& file);
    /// It is open again, or its like is kept.
    void forget(const std::filesystem::path& file);

private:
    void look_again();

    std::filesystem::path m_folder;
    std::vector<std::filesystem::path> m_files;
};

/// Whether closing without saving would have lost something.
bool has_unsaved(const Session& session);

/// What a person knows one by: "phosphor – Amber P3", from its name.
std::string title_of_kept(const std::filesystem::path& file);
