#include "lab/match/photo_matcher.h"

#include "gpu/objects/texels.h"
#include "io/files/atomic_file.h"
#include "lab/match/photo_check.h"
#include "model/photo/screen_corners.h"
#include "model/picture/reduced_picture.h"

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

struct PhotoMatcher::ReadPhoto {
    fs::path file;
    std::shared_ptr<const Picture> picture;
    std::optional<Corners> corners;
    Picture reduced;
};

/// What background threads hand over.
struct PhotoMatcher::Inbox {
    std::mutex mutex;
    std::optional<ReadPhoto> photo;
    std::optional<MatchProgress> progress;
    std::optional<Corners> better_corners;
};

namespace {
Result<gpu::Texture> display_texture(const Picture& picture) {
    return gpu::texture_of(picture, Format::rgba8, Encoding::display);
}
}  // namespace

void PhotoMatcher::open_photo(const fs::path& file) {
    cancel();
    m_inbox = std::make_shared<Inbox>();
    m_reading.start(
        [file, inbox = m_inbox, has_edges = !m_document || has_screen_edges(m_document->look())](
            JobProgress&) -> Result<bool> {
            constexpr int shown_side = 2048;
            auto photo = load_photo(file);
            if (!photo)
                return fail(photo.error());
            auto picture = std::make_shared<const Picture>(std::move(*photo));
            ReadPhoto read{file, picture, has_edges ? guess_corners(*picture) : std::nullopt,
                           reduced_picture(*picture, shown_side)};
            const std::lock_guard lock(inbox->mutex);
            inbox->photo = std::move(read);
            return true;
        });
}

void PhotoMatcher::move_corner(std::size_t corner, glm::dvec2 position) {
    if (!m_photo || is_running())
        return;
    const glm::dvec2 end(m_photo->picture->extent.width, m_photo->picture->extent.height);
    m_photo->corners.at(corner) = glm::clamp(position, glm::dvec2(0.0), end);
    magnify(corner);
}

void PhotoMatcher::magnify(std::size_t corner) {
    if (!m_photo)
        return;
    const Picture& photo = *m_photo->picture;
    const glm::ivec2 first =
        glm::ivec2(glm::floor(m_photo->corners.at(corner))) - magnified_side / 2;
    Picture part{{magnified_side, magnified_side}, 3, photo.encoding, {}};
    for (int y = 0; y < magnified_side; ++y)
        for (int x = 0; x < magnified_side; ++x) {
            const glm::ivec2 at = first + glm::ivec2(x, y);
            const bool is_inside =
                at.x >= 0 && at.y >= 0 && at.x < photo.extent.width && at.y < photo.extent.height;
            for (std::size_t channel = 0; channel < 3; ++channel)
                part.pixels.push_back(is_inside ? photo.pixels[photo.index(at.x, at.y) + channel]
                                                : 0.0F);
        }
    if (auto texture = display_texture(part))
        m_magnified = std::move(*texture);
}

void PhotoMatcher::start() {
    if (!m_photo || !m_document || is_running())
        return;
    m_shown.reset();
    m_better_corners.reset();
    m_inbox = std::make_shared<Inbox>();
    m_stop = std::make_shared<JobProgress>();
    m_work.start([document = *m_document, photo = m_photo->picture, corners = m_photo->corners,
                  file = m_photo->file, inbox = m_inbox,
                  stop = m_stop](JobProgress&) -> Result<MatchJobResult> {
        if (auto good = check_photo(*photo, corners, file); !good)
            return fail(good.error());
        return match({.prepared = {.document = document},
                      .photo = photo,
                      .file = file,
                      .corners = corners,
                      .on_progress =
                          [inbox](const MatchProgress& progress) {
                              const std::lock_guard lock(inbox->mutex);
                              inbox->progress = progress;
                          },
                      .draws_pictures = true,
                      .on_better_corners =
                          [inbox](const Corners& better) {
                              const std::lock_guard lock(inbox->mutex);
                              inbox->better_corners = better;
                          }},
                     *stop);
    });
}

void PhotoMatcher::stop() {
    if (m_stop)
        m_stop->is_cancelled = true;
}

void PhotoMatcher::cancel() {
    stop();
    m_work.cancel();
    m_reading.cancel();
    m_shown.reset();
}

void PhotoMatcher::apply(Document& document) const {
    if (const auto& outcome = m_work.outcome(); outcome && *outcome)
        set_found(document, (*outcome)->values);
}

Result<void> PhotoMatcher::attach_to(const fs::path& preset) const {
    const auto& outcome = m_work.outcome();
    if (!m_photo || !outcome || !*outcome)
        return {};
    fs::path copy = preset;
    copy.replace_extension(".photo" + m_photo->file.extension().string());
    if (auto copied = copy_atomically(m_photo->file, copy); !copied)
        return copied;
    fs::path camera = preset;
    camera.replace_extension(".camera.json");
    return write_atomically(camera, camera_json(**outcome));
}

void PhotoMatcher::show_progress() {
    std::optional<MatchProgress> progress;
    {
        const std::lock_guard lock(m_inbox->mutex);
        progress = std::exchange(m_inbox->progress, std::nullopt);
    }
    if (!progress || progress->pictures.photo.pixels.empty())
        return;
    auto photo = display_texture(progress->pictures.photo);
    auto seen = display_texture(progress->pictures.seen);
    if (m_messages.succeeded(photo) && m_messages.succeeded(seen))
        m_shown.emplace(Shown{std::move(progress->stage), progress->residual, std::move(*photo),
                              std::move(*seen)});
}

void PhotoMatcher::show_photo(ReadPhoto read) {
    auto texture = display_texture(read.reduced);
    if (!m_messages.succeeded(texture))
        return;
    const Extent extent = read.picture->extent;
    m_photo.emplace(OpenPhoto{std::move(read.file), std::move(read.picture),
                              read.corners.value_or(corners_of(extent)), read.corners.has_value(),
                              std::move(*texture)});
    magnify(0);
}

void PhotoMatcher::take_better_corners() {
    if (m_photo && m_better_corners)
        m_photo->corners = *m_better_corners;
    m_better_corners.reset();
}

void PhotoMatcher::update() {
    m_reading.update();
    m_work.update();
    if (!m_inbox)
        return;
    std::optional<ReadPhoto> read;
    {
        const std::lock_guard lock(m_inbox->mutex);
        read = std::exchange(m_inbox->photo, std::nullopt);
        if (const auto better = std::exchange(m_inbox->better_corners, std::nullopt))
            m_better_corners = better;
    }
    if (read)
        show_photo(std::move(*read));
    show_progress();
}
