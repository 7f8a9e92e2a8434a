#pragma once

#include "lab/storage/background_work.h"
#include "lab/views/view_image.h"
#include "model/look/look.h"
#include "model/preset/content.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class Lab;
class PresetThumbnailRenderer;

/// Thumbnails of all presets of the open look. A background thread draws them one after the other
/// while they are visible. They are drawn again after a preset has changed, and two seconds after
/// the last edit of the look.
class PresetThumbnails {
public:
    /// The displayed state of a preset.
    struct Shown {
        ViewImage image;      // row 0 at the bottom; a handle of 0: not drawn yet
        std::string problem;  // error; "": no error
        bool is_due = true;   // the image is outdated
    };

    /// How they are shown: not at all, those in the cache, or all, which are then drawn.
    enum class Use { hidden, cached, drawn };

    /// `wake` is called on the background thread when a picture is finished.
    explicit PresetThumbnails(std::function<void()> wake = {});
    ~PresetThumbnails();
    PresetThumbnails(const PresetThumbnails&) = delete;
    PresetThumbnails& operator=(const PresetThumbnails&) = delete;

    /// Call it in every update. Takes at most one finished picture. `content`: the signal or source
    /// of all pictures; nullopt: each preset's own.
    void update(const Lab& lab, Use use, double wall_seconds,
                const std::optional<Content>& content = {});
    /// "": the look without a preset.
    Shown of(const std::filesystem::path& preset) const;
    /// Whether a picture is still to be drawn or to be found in the cache.
    bool is_pending() const;
    /// The number of pictures drawn since the start, without cached ones.
    int drawn() const { return m_drawn; }

private:
    struct Basket;
    struct Entry {
        std::filesystem::file_time_type written;
        std::vector<std::filesystem::path> named;  // sounds and pictures that it uses
        std::string stamp;                         // of these when it was drawn
        std::optional<gpu::Texture> picture;
        std::string problem;
        bool is_due = true;
        bool is_uncached = false;  // it was looked for in the cache
    };

    bool is_wanted(const Entry& entry) const {
        return entry.is_due && (m_use == Use::drawn || !entry.is_uncached);
    }
    void list(const Lab& lab, const std::optional<Content>& content);
    void take_one();
    void start(const Lab& lab);

    std::function<void()> m_wake;
    std::optional<Look> m_look;        // of the pictures
    std::optional<Content> m_content;  // displayed in the pictures
    std::map<std::filesystem::path, Entry> m_entries;
    std::shared_ptr<Basket> m_basket;  // shared with the background thread
    double m_seconds_left = 0.0;       // until the folders are read again
    double m_rest_left = 0.0;          // s, until an edited look's pictures are drawn
    int m_drawn = 0;
    Use m_use = Use::hidden;
    BackgroundWork<bool> m_work;
};
