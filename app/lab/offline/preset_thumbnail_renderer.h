#pragma once

#include "base/job_progress.h"
#include "graph/inspect/viewer.h"
#include "lab/offline/offline.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Whether drawing in the background leaves half of the time to others, such as the window.
enum class Pace { half, full };

/// Draws thumbnails of the presets of a look, each from a fresh start like `render`, with its
/// input. They are cached in the user's state folder, under a digest of their inputs. Uses its own
/// GL context on the calling thread.
class PresetThumbnailRenderer {
public:
    /// `content`: the signal or source for all presets; nullopt: each preset's own.
    PresetThumbnailRenderer(Look look, Library library, std::optional<Content> content = {},
                            Pace pace = Pace::half);
    /// The height of the pictures; 135 before the first call. Their width follows.
    void set_lines(int lines) { m_lines = lines; }

    /// The picture of a preset; "": the look without a preset. Fails if the preset cannot be opened
    /// or drawn, and when cancelled.
    Result<Picture> paint(const std::filesystem::path& preset, const JobProgress& work);
    /// The cached picture of a preset, without drawing. nullopt: it must be drawn. Fails if the
    /// preset cannot be opened.
    Result<std::optional<Picture>> find_cached(const std::filesystem::path& preset);
    /// The sounds and pictures of the last preset, including missing ones.
    const std::vector<std::filesystem::path>& named_files() const { return m_named; }
    /// Their stamp before drawing.
    const std::string& stamp() const { return m_stamp; }

    /// The number of pictures drawn, without cached ones.
    int drawn() const { return m_drawn; }

private:
    Result<PreparedLook> prepared(const std::filesystem::path& preset) const;
    Result<PreparedLook> begin(const std::filesystem::path& preset);
    Result<Picture> draw(PreparedLook prepared, const JobProgress& work);
    Result<void> start(PreparedLook prepared);
    std::filesystem::path kept_file(const std::filesystem::path& preset) const;

    Document m_plain;
    Library m_library;
    std::optional<Content> m_content;
    Pace m_pace;
    int m_lines = 135;
    std::string m_look_text;           // text of all its files
    std::optional<Offline> m_offline;  // owns the context; outlives m_viewer
    std::optional<Viewer> m_viewer;
    std::vector<std::filesystem::path> m_named;
    std::string m_stamp;
    int m_drawn = 0;
};
