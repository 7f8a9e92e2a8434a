#pragma once

#include "formats/settings/session_format.h"
#include "lab/storage/roots.h"
#include "model/look/picture.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// A stored session with unsaved changes, for display in a list.
struct StashedSession {
    std::filesystem::path file;
    std::filesystem::path picture;  // a PNG; may not exist
    std::string look;               // its id, or "a+b"
    std::string preset;             // its name; "": the look's defaults
    std::size_t changes = 0;        // changed values, content, modulations and passes
    std::filesystem::file_time_type time;
};

/// Stores unsaved changes when another look is opened: the latest 12, one file each.
class SessionStash {
public:
    explicit SessionStash(const Roots& roots);

    /// The latest first.
    const std::vector<std::filesystem::path>& files() const { return m_files; }
    /// The files with their contents; each is read only once.
    const std::vector<StashedSession>& list() const;
    /// Stores a session with unsaved changes, unless the latest stored one is the same. False: no
    /// unsaved changes. `picture` renders the displayed picture; it is only called if needed.
    Result<bool> keep(const Session& session,
                      const std::function<std::optional<Picture>()>& picture = {});
    /// Reads a stored session. A damaged file is not deleted.
    static Result<Session> read(const std::filesystem::path& file);
    /// Deletes a stored session, such as after it was restored.
    void forget(const std::filesystem::path& file);

private:
    void look_again();

    std::filesystem::path m_folder;
    std::vector<std::filesystem::path> m_files;
    mutable std::vector<StashedSession> m_list;  // cached entries of m_files
};

/// Whether closing without saving would lose changes.
bool has_unsaved(const Session& session);

/// The number of differences from the saved state. Locked content does not count.
std::size_t count_changes(const Session& session);

/// "just now", "10 min ago", "3 h ago", "2 days ago".
std::string age_text(double seconds);
