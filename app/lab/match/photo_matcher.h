#pragma once

#include "gpu/objects/texture.h"
#include "lab/match/match_job.h"
#include "lab/messages/messages.h"
#include "lab/storage/background_work.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

/// Matches the open look to a photo in the background, with what the window shows of it.
class PhotoMatcher {
public:
    /// A photo and its corners, which the user moves.
    struct OpenPhoto {
        std::filesystem::path file;
        std::shared_ptr<const Picture> picture;
        Corners corners;
        bool has_edges = false;  // the corners were guessed from them
        gpu::Texture texture;    // smaller than the photo
    };
    /// What a match shows while it works.
    struct Shown {
        std::string stage;
        double residual = 0.0;
        gpu::Texture photo;
        gpu::Texture seen;
    };

    PhotoMatcher(const std::optional<Document>& document, Messages& messages)
        : m_document(document), m_messages(messages) {}
    ~PhotoMatcher() { cancel(); }
    PhotoMatcher(const PhotoMatcher&) = delete;
    PhotoMatcher& operator=(const PhotoMatcher&) = delete;

    /// Reads a photo in the background and guesses its corners.
    void open_photo(const std::filesystem::path& file);
    const BackgroundWork<bool>& reading() const { return m_reading; }
    const std::optional<OpenPhoto>& photo() const { return m_photo; }
    /// `position`: px of the photo.
    void move_corner(std::size_t corner, glm::dvec2 position);
    /// A square around a corner, `magnified_side` px of the photo wide.
    const std::optional<gpu::Texture>& magnified() const { return m_magnified; }
    void magnify(std::size_t corner);
    static constexpr int magnified_side = 48;

    /// Matches the document, with its source, to the photo.
    void start();
    /// Ends the match with the numbers that it has found.
    void stop();
    /// Ends the match and forgets its numbers. Photo and corners stay.
    void cancel();
    const BackgroundWork<MatchJobResult>& work() const { return m_work; }
    const std::optional<Shown>& shown() const { return m_shown; }
    /// Corners that the last match, which was refused, would fit better.
    const std::optional<Corners>& better_corners() const { return m_better_corners; }
    void take_better_corners();
    /// Puts the found values into the document as one undo step.
    void apply(Document& document) const;
    /// Saves the photo and the camera next to a preset: NAME.photo.EXT and NAME.camera.json.
    Result<void> attach_to(const std::filesystem::path& preset) const;

    void update();
    bool is_running() const { return m_reading.is_running() || m_work.is_running(); }

private:
    struct ReadPhoto;
    struct Inbox;  // of the background threads

    void show_photo(ReadPhoto read);
    void show_progress();

    const std::optional<Document>& m_document;
    Messages& m_messages;
    std::shared_ptr<Inbox> m_inbox;
    std::shared_ptr<JobProgress> m_stop;  // of the running match
    BackgroundWork<bool> m_reading;
    BackgroundWork<MatchJobResult> m_work;
    std::optional<OpenPhoto> m_photo;
    std::optional<gpu::Texture> m_magnified;
    std::optional<Shown> m_shown;
    std::optional<Corners> m_better_corners;
};
