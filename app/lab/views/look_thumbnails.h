#pragma once

#include "lab/library/library_view.h"
#include "lab/storage/background_work.h"
#include "lab/views/view_image.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

/// Small pictures of looks. The file look.png in a look's folder is its picture. Looks without one
/// are drawn in the background, and cached in the user's state folder under a digest of their
/// files.
class LookThumbnails {
public:
    /// `wake` is called on the background thread when a picture is finished.
    explicit LookThumbnails(std::function<void()> wake = {});
    ~LookThumbnails();
    LookThumbnails(const LookThumbnails&) = delete;
    LookThumbnails& operator=(const LookThumbnails&) = delete;

    /// Takes finished pictures, and reads those that of() asked for. Call it in every update.
    void read();
    /// Draws looks without a picture, one at a time. Call it in every update while the list of
    /// looks is visible. `can_draw`: the machine has time to draw; otherwise only cached ones are
    /// shown.
    void draw(const Library& library, const std::vector<ListedLook>& looks, bool can_draw,
              double wall_seconds);
    /// Row 0 at the bottom; a handle of 0: no picture, or not read yet.
    ViewImage of(const std::filesystem::path& folder) const;

private:
    struct Finished;
    struct Entry {
        std::string stamp;  // of the look's files
        bool is_due = true;
    };

    void list(const std::vector<ListedLook>& looks);
    void start_drawing(const Library& library, const std::filesystem::path& folder,
                       const std::filesystem::path& file);

    std::function<void()> m_wake;
    std::map<std::filesystem::path, gpu::Texture> m_pictures;  // by folder
    mutable std::set<std::filesystem::path> m_asked;           // folders to look into for look.png
    std::set<std::filesystem::path> m_known;                   // folders that were looked into
    std::map<std::filesystem::path, Entry> m_entries;          // looks without look.png, by folder
    double m_seconds_left = 0.0;                               // until the folders are listed again
    std::shared_ptr<Finished> m_finished;                      // shared with the background threads
    BackgroundWork<bool> m_reading;
    BackgroundWork<bool> m_drawing;
};
