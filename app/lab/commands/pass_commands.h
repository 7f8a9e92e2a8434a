#pragma once

#include "formats/look/pass_edit.h"
#include "lab/commands/file_edit.h"
#include "lab/frame/workspace.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>

/// Adds, removes and moves passes of the open look by editing its files. Each edit is an undo step
/// of the document; undoing it restores the files, unless another program has changed them since.
/// The reloader then reads the look again.
class PassCommands {
public:
    explicit PassCommands(Workspace& work) : m_work(work) {}

    /// Why the look of a pass can't be edited: it is shipped, or in another program's format.
    std::optional<std::string> refusal(const std::string& pass) const;
    /// Shows the refusal, with an offer to duplicate a shipped look. False: there is none.
    bool refuse(const std::string& pass);
    /// A free name for a pass after this one.
    std::string proposed_name(const std::string& after) const;
    /// Why a new pass can't have this name; "": it can.
    std::string problem_of_name(const std::string& after, const std::string& name) const;

    /// Adds a pass with its own shader after another one. It leaves the picture unchanged. Passes
    /// are named as in the open look, so in a stack as "crt/screen"; the new name is without key.
    void add(const std::string& after, const std::string& name);
    /// Removes a pass, and its shaders if no other pass names them.
    void remove(const std::string& pass);
    void move(const std::string& pass, PassMove move);

    /// Call it in every update: undoes and redoes edits of files with the document.
    void update();
    /// Call it when another look was opened: its files have no edits.
    void forget();

private:
    /// A pass in the files of its look.
    struct Located {
        std::filesystem::path manifest;
        std::string name;  // within the look
    };
    struct Made {
        std::size_t from = 0;  // the edit that it was based on
        std::string name;      // "Add pass glow"
        FileEdit files;
    };

    std::optional<Located> locate(const std::string& pass) const;
    std::optional<Located> start(const std::string& pass);
    void finish(std::string name, FileEdit files, std::string notice, const Located& pass);
    void restore(std::size_t wanted);
    bool write(const FileEdit& files, const std::string& name);

    Workspace& m_work;
    std::map<std::size_t, Made> m_edits;  // by DocumentState::files
    std::size_t m_applied = 0;            // the edit that the files have
};
