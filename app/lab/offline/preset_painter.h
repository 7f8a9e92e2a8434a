#pragma once

#include "base/work.h"
#include "graph/inspect/viewer.h"
#include "lab/offline/offline.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Draws small pictures of the presets of one look, each from a fresh start as `render` does, with
/// what drives it. What has been drawn is kept in a folder of the person's, by what it was drawn
/// from. Has a GL context of its own, for the thread that paints.
class PresetPainter {
public:
    /// `content`: the signal or source that every preset is drawn with; none: its own.
    PresetPainter(Look look, Library library, std::optional<Content> content = {});

    /// The picture of a preset's file; "": of the look as it is. Rests as long as it works, so that
    /// the window has most of the machine. Fails where the preset cannot be opened or drawn, and
    /// when it is cancelled.
    Result<Picture> paint(const std::filesystem::path& preset, const Work& work);
    /// The sounds and pictures that the last preset names, there or not.
    const std::vector<std::filesystem::path>& named_files() const { return m_named; }
    /// Of these, before it was drawn.
    const std::string& stamp() const { return m_stamp; }

    /// How many were drawn, and not found as they were kept.
    int drawn() const { return m_drawn; }

private:
    Result<Prepared> prepared(const std::filesystem::path& preset) const;
    Result<Picture> draw(Prepared prepared, const Work& work);
    Result<void> start(Prepared prepared);
    std::filesystem::path kept_file(const std::filesystem::path& preset) const;

    Document m_plain;
    Library m_library;
    std::optional<Content> m_content;
    std::string m_look_text;           // all that the look was read from
    std::optional<Offline> m_offline;  // owns the context, so it goes last
    std::optional<Viewer> m_viewer;
    std::vector<std::filesystem::path> m_named;
    std::string m_stamp;
    int m_drawn = 0;
};
