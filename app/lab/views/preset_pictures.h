#pragma once

#include "gpu/objects/texture.h"
#include "lab/storage/background_work.h"
#include "lab/views/views.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class Lab;
class PresetPainter;

/// A small picture of each preset of the open look. They are drawn one after the other on a thread
/// of its own while somebody looks, and drawn anew when a preset or the look has changed.
class PresetPictures {
public:
    /// What stands in a preset's place.
    struct Shown {
        Views::Image image;   // row 0 at the bottom; without a handle where there is none yet
        std::string problem;  // why there is none; "": it is yet to come
        bool is_due = true;   // what is seen is not what it is now
    };

    /// `wake` is called on the other thread when a picture is there to be taken.
    explicit PresetPictures(std::function<void()> wake = {});
    ~PresetPictures();
    PresetPictures(const PresetPictures&) = delete;
    PresetPictures& operator=(const PresetPictures&) = delete;

    /// To be called every turn; `is_seen`: they are on screen. Takes at most one picture in.
    /// `content`: the signal or source that all of them show; none: each preset's own.
    void update(const Lab& lab, bool is_seen, double wall_seconds,
                const std::optional<Content>& content = {});
    /// "": of the look as it is.
    Shown of(const std::filesystem::path& preset) const;
    bool is_drawing() const { return m_work.is_running(); }
    /// How many the painter has drawn since the start, and not found as they were kept.
    int drawn() const { return m_drawn; }

private:
    struct Basket;
    struct Entry {
        std::filesystem::file_time_type written;
        std::vector<std::filesystem::path> named;  // sounds and pictures that it was drawn with
        std::string stamp;                         // of these, then
        std::optional<gpu::Texture> picture;
        std::string problem;
        bool is_due = true;
    };

    void list(const Lab& lab, const std::optional<Content>& content);
    void take_one();
    void start(const Lab& lab);

    std::function<void()> m_wake;
    std::optional<Look> m_look;        // that they are of
    std::optional<Content> m_content;  // that they show
    std::map<std::filesystem::path, Entry> m_entries;
    std::shared_ptr<Basket> m_basket;  // shared with the thread that paints
    double m_seconds_left = 0.0;       // until the folders are read again
    int m_drawn = 0;
    BackgroundWork<bool> m_work;
};
