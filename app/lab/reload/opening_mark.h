#pragma once

#include "io/system/locked_file.h"
#include "lab/library/open.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// A look that was being opened or compiled when the program ended.
struct UnfinishedOpening {
    std::string look;                           // its name
    std::vector<std::filesystem::path> places;  // manifests or foreign files, of a stack several
    std::filesystem::path edited = {};          // the file whose edit was compiled; "": none
    bool is_reset = false;                      // the driver lost the context while it drew

    /// The file to look into first.
    std::filesystem::path file() const { return edited.empty() ? places.front() : edited; }
    /// Whether a look.json or foreign file is one of its places.
    bool has(const std::filesystem::path& manifest) const;

    bool operator==(const UnfinishedOpening&) const = default;
};

/// A file in the state folder that names the look which compilers and driver are given. It stays
/// behind where one of them ends the program. Locked while the program runs, so that another run
/// does not take it for a crash.
class OpeningMark {
public:
    explicit OpeningMark(const Roots& roots);
    /// Removes the file: all went well.
    ~OpeningMark();
    OpeningMark(const OpeningMark&) = delete;
    OpeningMark& operator=(const OpeningMark&) = delete;

    /// To be called before a look is compiled; `edited` is the file that changed, "" for none.
    /// Forgets what runs before this one left behind. Where it cannot be written nothing is.
    void begin(const OpenRequest& request, const std::filesystem::path& edited);
    /// The look has drawn, or was refused in words.
    void end();
    /// The driver lost the context while it drew the look: the file stays.
    void leave(const OpenRequest& request);
    bool is_set() const { return m_file.is_open(); }
    /// To be called once per update: whether nothing is loaded and the picture is whole. After a
    /// few such updates in a row the look counts as opened, as with end().
    void note_update(bool is_quiet);

private:
    void write(const std::string& text);

    std::filesystem::path m_folder;
    std::filesystem::path m_name;
    LockedFile m_file;
    int m_quiet_updates = 0;
};

/// What a run that is over left behind; none: nothing, or that run goes on.
std::optional<UnfinishedOpening> find_unfinished_opening(const Roots& roots);
