#pragma once

#include "io/system/locked_file.h"
#include "lab/library/open.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// A look that was being opened or compiled when the program ended.
struct UnfinishedOpening {
    std::string look;                          // its name
    std::vector<std::filesystem::path> paths;  // manifests or foreign files; several for a stack
    std::filesystem::path edited = {};         // the file whose edit was compiled; "": none
    bool is_reset = false;                     // the driver lost the context while drawing

    /// The file to check first.
    std::filesystem::path file() const { return edited.empty() ? paths.front() : edited; }
    /// Whether a look.json or foreign file is one of its paths.
    bool has(const std::filesystem::path& manifest) const;

    bool operator==(const UnfinishedOpening&) const = default;
};

/// A file in the state folder with the name of the look that is being compiled. It stays if a
/// compiler or the driver ends the program. It is locked while the program runs, so that another
/// run does not take it for a crash.
class CrashMarker {
public:
    explicit CrashMarker(const Roots& roots);
    /// Removes the file, as the program ends normally.
    ~CrashMarker();
    CrashMarker(const CrashMarker&) = delete;
    CrashMarker& operator=(const CrashMarker&) = delete;

    /// Call before a look is compiled. `edited` is the file that changed, or "". Removes the marks
    /// of previous runs. If the file cannot be written, nothing is marked.
    void begin(const OpenRequest& request, const std::filesystem::path& edited);
    /// Call when the look has drawn or was refused with an error.
    void end();
    /// Call when the driver lost the context while it drew the look. The file stays.
    void leave(const OpenRequest& request);
    bool is_set() const { return m_file.is_open(); }
    /// Call once per update. `is_quiet`: nothing is loaded and the picture is complete. After a few
    /// such updates the look counts as opened, as with end(). On a slow machine other updates are
    /// between them.
    void note_update(bool is_quiet);

private:
    void write(const std::string& text);

    std::filesystem::path m_folder;
    std::filesystem::path m_name;
    LockedFile m_file;
    int m_quiet_updates = 0;
};

/// The mark of a run that crashed; nullopt: none, or that run has not ended.
std::optional<UnfinishedOpening> find_unfinished_opening(const Roots& roots);
