#include "lab/views/look_thumbnails.h"

#include "base/text.h"
#include "gpu/objects/texels.h"
#include "io/pictures/picture_file.h"
#include "lab/library/look_templates.h"
#include "lab/offline/preset_thumbnail_renderer.h"
#include "lab/storage/file_stamp.h"
#include "lab/storage/picture_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

namespace fs = std::filesystem;

namespace {
std::optional<gpu::Texture> texture_of(const Picture& picture) {
    auto made = gpu::texture_of(picture, Format::rgba8, Encoding::display);
    return made ? std::optional(std::move(*made)) : std::nullopt;
}

// The stamps of the files in a look's folder; of many files, the first.
std::string stamp_of(const fs::path& folder) {
    constexpr std::size_t maximum = 500;
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end;
         !error && it != end && files.size() < maximum; it.increment(error))
        files.push_back(it->path());
    std::ranges::sort(files);
    return stamp_text(files);
}

fs::path cached_file(const Roots& roots, const fs::path& folder, const std::string& stamp) {
    const std::string all = fmt::format("1 {}\n{}", folder.string(), stamp);
    return roots.state / "look-pictures" / fmt::format("{:016x}.png", digest_of(all));
}

// A look that never converges ends like a preset's picture, after 120 frames.
Result<Picture> drawn(const fs::path& folder, const Library& library, const JobProgress& work) {
    RenderRequest request;
    request.look = folder.string();
    auto prepared = prepare(request, library);
    if (!prepared)
        return fail(prepared.error());
    return PresetThumbnailRenderer(prepared->document.look(), library).paint({}, work);
}
}  // namespace

/// The pictures that have not been displayed yet.
struct LookThumbnails::Finished {
    void add(const fs::path& folder, Picture picture) {
        const std::lock_guard lock(mutex);
        pictures.emplace_back(folder, std::move(picture));
    }
    std::vector<std::pair<fs::path, Picture>> take() {
        const std::lock_guard lock(mutex);
        return std::exchange(pictures, {});
    }

    std::mutex mutex;
    std::vector<std::pair<fs::path, Picture>> pictures;
};

LookThumbnails::LookThumbnails(std::function<void()> wake)
    : m_wake(std::move(wake)), m_finished(std::make_shared<Finished>()) {}

LookThumbnails::~LookThumbnails() = default;

ViewImage LookThumbnails::of(const fs::path& folder) const {
    const auto picture = m_pictures.find(folder);
    if (picture != m_pictures.end())
        return image_of(&picture->second);
    if (!m_known.contains(folder))
        m_asked.insert(folder);
    return {};
}

void LookThumbnails::read() {
    m_reading.update();
    for (const auto& [folder, picture] : m_finished->take())
        if (auto texture = texture_of(picture)) {
            m_pictures.erase(folder);
            m_pictures.emplace(folder, std::move(*texture));
        }
    if (m_asked.empty() || !m_reading.is_free())
        return;
    m_known.insert(m_asked.begin(), m_asked.end());
    m_reading.start([folders = std::exchange(m_asked, {}), finished = m_finished,
                     wake = m_wake](JobProgress&) -> Result<bool> {
        for (const fs::path& folder : folders) {
            std::error_code error;
            if (!fs::exists(folder / picture_name, error))
                continue;
            if (auto picture = load_picture(folder / picture_name))
                finished->add(folder, std::move(*picture));
        }
        if (wake)
            wake();
        return true;
    });
}

void LookThumbnails::list(const std::vector<ListedLook>& looks) {
    std::map<fs::path, Entry> listed;
    for (const ListedLook& look : looks) {
        const fs::path& folder = look.entry.folder;
        std::error_code error;
        if (look.is_stack() || !fs::exists(folder / "look.json", error) ||
            fs::exists(folder / picture_name, error))
            continue;
        Entry& entry = listed[folder];
        if (const auto known = m_entries.find(folder); known != m_entries.end())
            entry = std::move(known->second);
        std::string stamp = stamp_of(folder);
        entry.is_due = entry.is_due || entry.stamp != stamp;
        entry.stamp = std::move(stamp);
    }
    m_entries = std::move(listed);
}

// A look that cannot be drawn keeps its previous picture, and is tried again when its files change.
void LookThumbnails::draw(const Library& library, const std::vector<ListedLook>& looks,
                          bool can_draw, double wall_seconds) {
    m_drawing.update();
    m_seconds_left -= wall_seconds;
    if (m_seconds_left <= 0.0) {
        constexpr double pause_seconds = 3.0;
        m_seconds_left = pause_seconds;
        list(looks);
    }
    const auto due = std::ranges::find_if(m_entries, [](const auto& e) { return e.second.is_due; });
    if (due == m_entries.end())
        return;
    auto& [folder, entry] = *due;
    const fs::path file = cached_file(library.roots(), folder, entry.stamp);
    std::error_code error;
    auto cached = fs::exists(file, error) ? std::optional(load_picture(file)) : std::nullopt;
    if (cached && *cached) {
        entry.is_due = false;
        return m_finished->add(folder, std::move(**cached));
    }
    if (!can_draw || !m_drawing.is_free())
        return;
    entry.is_due = false;
    start_drawing(library, folder, file);
}

void LookThumbnails::start_drawing(const Library& library, const fs::path& folder,
                                   const fs::path& file) {
    m_drawing.start([folder, library, file, finished = m_finished,
                     wake = m_wake](JobProgress& work) -> Result<bool> {
        auto picture = drawn(folder, library, work);
        if (!picture)
            return fail(picture.error());
        if (save_picture(*picture, file))  // without the cache, it is drawn again
            forget_old(file.parent_path());
        finished->add(folder, std::move(*picture));
        if (wake)
            wake();
        return true;
    });
}
