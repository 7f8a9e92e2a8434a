#include "lab/views/look_thumbnails.h"

#include "base/text.h"
#include "gpu/objects/texels.h"
#include "io/pictures/picture_file.h"
#include "lab/library/look_templates.h"
#include "lab/offline/preset_thumbnail_renderer.h"
#include "lab/storage/file_stamp.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
std::optional<gpu::Texture> texture_of(const Picture& picture) {
    auto made = gpu::texture_of(picture, Format::rgba8, Encoding::display);
    return made ? std::optional(std::move(*made)) : std::nullopt;
}

std::optional<gpu::Texture> texture_in(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error))
        return std::nullopt;
    const auto picture = load_picture(file);
    return picture ? texture_of(*picture) : std::nullopt;
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

// A look that draws slowly or never converges ends like a preset's picture, after 120 frames.
Result<Picture> draw(const fs::path& folder, const Library& library, const fs::path& file,
                     const JobProgress& work) {
    RenderRequest request;
    request.look = folder.string();
    auto prepared = prepare(request, library);
    if (!prepared)
        return fail(prepared.error());
    PresetThumbnailRenderer renderer(prepared->document.look(), library);
    auto picture = renderer.paint({}, work);
    if (picture)
        (void)save_picture(*picture, file);  // without the cache, it is drawn again
    return picture;
}
}  // namespace

ViewImage LookThumbnails::of(const fs::path& folder) const {
    const auto known = m_files.find(folder);
    if (known == m_files.end()) {
        m_files[folder] = texture_in(folder / picture_name);
        return of(folder);
    }
    if (known->second)
        return image_of(&*known->second);
    const auto entry = m_entries.find(folder);
    return image_of(entry != m_entries.end() && entry->second.picture ? &*entry->second.picture
                                                                      : nullptr);
}

void LookThumbnails::update(const Library& library, const std::vector<ListedLook>& looks,
                            bool can_draw, double wall_seconds) {
    m_work.update();
    take_drawn();
    m_seconds_left -= wall_seconds;
    if (m_seconds_left <= 0.0) {
        constexpr double pause_seconds = 3.0;
        m_seconds_left = pause_seconds;
        list(looks);
    }
    show_next(library, can_draw);
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

// A look that cannot be drawn keeps its previous picture until its files change.
void LookThumbnails::take_drawn() {
    if (!m_work.outcome() || m_drawn.empty())
        return;
    const auto entry = m_entries.find(std::exchange(m_drawn, {}));
    if (entry != m_entries.end() && *m_work.outcome())
        if (auto texture = texture_of(**m_work.outcome()))
            entry->second.picture = std::move(texture);
}

void LookThumbnails::show_next(const Library& library, bool can_draw) {
    const auto due = std::ranges::find_if(m_entries, [](const auto& e) { return e.second.is_due; });
    if (due == m_entries.end())
        return;
    auto& [folder, entry] = *due;
    const fs::path file = cached_file(library.roots(), folder, entry.stamp);
    if (auto texture = texture_in(file)) {
        entry.picture = std::move(texture);
        entry.is_due = false;
    } else if (can_draw && m_work.is_free()) {
        entry.is_due = false;
        m_drawn = folder;
        m_work.start([folder = folder, library, file, wake = m_wake](JobProgress& work) {
            auto picture = draw(folder, library, file, work);
            if (wake)
                wake();
            return picture;
        });
    }
}
