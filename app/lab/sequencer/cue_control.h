#pragma once

#include "formats/cues/cue_sheet.h"
#include "lab/frame/frame_loop.h"
#include "lab/frame/workspace.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The cues in the window: reads, plays, edits and saves a cue file. Its text is part of the
/// document's state, so edits have undo and the session keeps them. The cues stay with the next
/// look.
class CueControl {
public:
    CueControl(Workspace& work, FrameLoop& frames) : m_work(work), m_frames(frames) {}

    /// Opens a cue file, as one undo step.
    void open(const std::filesystem::path& file);
    void close();
    /// Writes the text. Only edited lines differ from the file that was read.
    void save();
    void save_as(const std::filesystem::path& file);
    /// The files that the cues come from: the cue file and its presets.
    std::vector<std::filesystem::path> files() const;
    /// Call when one of files() changed on disk. Unsaved edits stay.
    void file_changed(const std::filesystem::path& file);
    /// Call when the look or a pass of it was replaced.
    void look_changed() { m_is_stale = true; }

    /// How a cue names the open preset; "": none is open.
    std::string open_preset() const;

    /// Each edit is one undo step. `line` from 1.
    void add(const Cue& cue);
    void move(std::size_t line, double seconds);
    /// Replaces a cue by a typed one; an error in the text changes nothing.
    void retype(std::size_t line, const std::string& text);
    void remove(std::size_t line);

    /// Whether cues are applied while any are open.
    bool is_playing() const { return m_is_playing; }
    void set_playing(bool is_playing);

    /// Whether cues are open.
    bool is_open() const;
    /// Whether there are edits that are not in the file.
    bool has_changes() const;
    /// The cues of the open text; nullopt: none are open, or the text has errors.
    const std::optional<CueSheet>& sheet() const { return m_sheet; }
    /// The errors of the text, or of its cues for this look. The cues then don't play.
    const Diagnostics& problems() const { return m_problems; }

    /// What plays, for an export; null: nothing.
    const std::shared_ptr<const CuePlan>& plan() const { return m_work.cues; }

    /// Call it in every update.
    void update();

private:
    CueText current() const;
    void change(CueText next, const char* step);
    void change(const CueSheet& next, const char* step);
    void write(const std::filesystem::path& file);
    void compare_with_file();
    void read();

    Workspace& m_work;
    FrameLoop& m_frames;
    CueText m_read;           // source of m_sheet and m_problems
    bool m_is_stale = false;  // the look or a preset has changed since
    std::vector<std::filesystem::path> m_presets;
    CueText m_saved;  // as in the file
    std::optional<CueSheet> m_sheet;
    Diagnostics m_problems;
    bool m_is_playing = true;
};
