#pragma once

#include "formats/settings/session_format.h"
#include "lab/storage/roots.h"
#include "model/look/picture.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What a list says of unsaved changes that are kept.
struct KeptSession {
    std::filesystem::path file;
    std::filesystem::path picture;  // a PNG; need not exist
    std::string look;               // its id, or "a+b"
    std::string preset;             // its name; "": the look's defaults were open
    std::size_t changes = 0;        // values, signal or source, modulations and passes
    std::filesystem::file_time_type time;
};

/// Unsaved changes whose place another look took, in a file each: the latest dozen.
class KeptSessions {
public:
    explicit KeptSessions(const Roots& roots);

    /// The latest first.
    const std::vector<std::filesystem::path>& files() const { return m_files; }
    /// The same with what their files say; each is read once.
    const std::vector<KeptSession>& list() const;
    /// Keeps a session that has unsaved changes, the same but once. True where there were some.
    /// `picture` draws what was seen; it is called only where it is needed.
    Result<bool> keep(const Session& session,
                      const std::function<std::optional<Picture>()>& picture = {});
    /// What a file holds; a damaged one stays where it is.
    static Result<Session> read(const std::filesystem::path& file);
    /// It is open again, or its like is kept.
    void forget(const std::filesystem::path& file);

private:
    void look_again();

    std::filesystem::path m_folder;
    std::vector<std::filesystem::path> m_files;
    mutable std::vector<KeptSession> m_list;  // of m_files, as far as they were asked for
};

/// Whether closing without saving would have lost something.
bool has_unsaved(const Session& session);

/// How many things differ from what was saved. Locked content does not count.
std::size_t count_changes(const Session& session);

/// "just now", "10 min ago", "3 h ago", "2 days ago".
std::string age_text(double seconds);
