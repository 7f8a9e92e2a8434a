#pragma once

#include "lab/library/library_view.h"
#include "lab/storage/background_work.h"
#include "lab/views/view_image.h"
#include "model/look/picture.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Small pictures of looks. The file look.png in a look's folder is its picture. Looks without one
/// are drawn in the background, and cached in the user's state folder under a digest of their
/// files.
class LookThumbnails {
public:
    /// `wake` is called on the background thread when a picture is finished.
    explicit LookThumbnails(std::function<void()> wake = {}) : m_wake(std::move(wake)) {}

    /// Call it in every update while the list of looks is visible. Takes or starts at most one
    /// picture. `can_draw`: the machine has time to draw; otherwise only cached ones are shown.
    void update(const Library& library, const std::vector<ListedLook>& looks, bool can_draw,
                double wall_seconds);
    /// Row 0 at the bottom; a handle of 0: no picture. Reads look.png when it is first displayed.
    ViewImage of(const std::filesystem::path& folder) const;
    bool is_drawing() const { return m_work.is_running(); }

private:
    struct Entry {
        std::string stamp;  // of the files that it was drawn from
        bool is_due = true;
        std::optional<gpu::Texture> picture;
    };

    void list(const std::vector<ListedLook>& looks);
    void take_drawn();
    void show_next(const Library& library, bool can_draw);

    std::function<void()> m_wake;
    mutable std::map<std::filesystem::path, std::optional<gpu::Texture>> m_files;  // look.png
    std::map<std::filesystem::path, Entry> m_entries;  // looks without such a file, by folder
    double m_seconds_left = 0.0;                       // until the folders are read again
    std::filesystem::path m_drawn;                     // the folder that the work draws
    BackgroundWork<Picture> m_work;
};
