#include "lab/views/preset_thumbnails.h"

#include "gpu/objects/texels.h"
#include "lab/lab.h"
#include "lab/offline/preset_thumbnail_renderer.h"
#include "lab/storage/file_stamp.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

namespace fs = std::filesystem;

namespace {
std::string message_of(const Diagnostic& problem) {
    return problem.line > 0 ? fmt::format("line {}: {}", problem.line, problem.message)
                            : problem.message;
}
}  // namespace

/// The finished pictures that have not been displayed yet.
struct PresetThumbnails::Basket {
    struct Painted {
        fs::path preset;
        fs::file_time_type written;              // at the time of the request
        Result<std::optional<Picture>> picture;  // nullopt: not in the cache
        std::vector<fs::path> named;
        std::string stamp;
        int drawn = 0;
    };

    bool is_empty() {
        const std::lock_guard lock(mutex);
        return painted.empty();
    }

    std::mutex mutex;
    std::deque<Painted> painted;
};

PresetThumbnails::PresetThumbnails(std::function<void()> wake)
    : m_wake(std::move(wake)), m_basket(std::make_shared<Basket>()) {}

PresetThumbnails::~PresetThumbnails() = default;

void PresetThumbnails::update(const Lab& lab, Use use, double wall_seconds,
                              const std::optional<Content>& content) {
    m_work.update();
    if (std::exchange(m_use, use) == Use::drawn && use == Use::cached)
        m_work.cancel();  // does not draw any more
    if (use == Use::hidden || !lab.document() || !lab.renderer()) {
        m_work.cancel();
        m_seconds_left = 0.0;
        return;
    }
    take_one();
    m_seconds_left -= wall_seconds;
    m_rest_left -= wall_seconds;
    if (m_seconds_left <= 0.0) {
        constexpr double pause_seconds = 0.5;
        m_seconds_left = pause_seconds;
        list(lab, content);
    }
    const bool is_any_wanted =
        std::ranges::any_of(m_entries, [this](const auto& e) { return is_wanted(e.second); });
    if (is_any_wanted && m_rest_left <= 0.0 && m_work.is_free() &&
        m_basket->is_empty())  // otherwise the picture may be there
        start(lab);
}

bool PresetThumbnails::is_pending() const {
    return m_use != Use::hidden && std::ranges::any_of(m_entries, [this](const auto& entry) {
               return is_wanted(entry.second);
           });
}

namespace {
// Changed constants do not affect presets, which define their own values.
bool differs_in_constants(const Look& before, const Look& now) {
    return before.constants != now.constants &&
           std::ranges::equal(before.constants, now.constants, {}, &Values::value_type::first,
                              &Values::value_type::first);
}
}  // namespace

// Edited presets are drawn again, after a rest. The previous pictures stay until then.
void PresetThumbnails::list(const Lab& lab, const std::optional<Content>& content) {
    const Look& look = lab.document()->look();
    const bool is_other = !m_look || m_look->id != look.id;
    const bool is_turned = !is_other && differs_in_constants(*m_look, look);
    const bool shows_other = std::exchange(m_content, content) != content;
    const bool is_edited = !is_other && ((!is_turned && *m_look != look) || shows_other);
    if (is_turned)
        m_look = look;
    constexpr double rest_seconds = 2.0;  // the next edit should not wait for pictures of this one
    if (!is_other && !is_turned && *m_look != look)
        m_rest_left = rest_seconds;
    if (is_other)
        m_entries.clear();
    if (is_other || is_edited) {
        m_work.cancel();
        m_basket = std::make_shared<Basket>();  // discards pictures of the previous look
        m_look = look;
    }
    std::map<fs::path, Entry> listed;
    const auto add = [&](const fs::path& file, fs::file_time_type written) {
        Entry& entry = listed[file];
        if (const auto known = m_entries.find(file); known != m_entries.end())
            entry = std::move(known->second);
        const bool is_changed =
            is_edited || entry.written != written || stamp_text(entry.named) != entry.stamp;
        entry.is_due = entry.is_due || is_changed;
        entry.is_uncached = entry.is_uncached && !is_changed;
        entry.written = written;
    };
    add({}, {});
    for (const PresetEntry& preset : lab.work().library.presets(look.id)) {
        std::error_code error;
        add(preset.file, fs::last_write_time(preset.file, error));
    }
    m_entries = std::move(listed);
}

void PresetThumbnails::take_one() {
    std::optional<Basket::Painted> painted;
    {
        const std::lock_guard lock(m_basket->mutex);
        if (m_basket->painted.empty())
            return;
        painted = std::move(m_basket->painted.front());
        m_basket->painted.pop_front();
    }
    m_drawn += painted->drawn;
    const auto found = m_entries.find(painted->preset);
    if (found == m_entries.end() || found->second.written != painted->written)
        return;
    Entry& entry = found->second;
    entry.named = std::move(painted->named);
    entry.stamp = std::move(painted->stamp);
    if (painted->picture && !*painted->picture) {
        entry.is_uncached = true;
        return;
    }
    entry.is_due = false;
    entry.problem.clear();
    entry.picture.reset();
    if (!painted->picture) {
        entry.problem = message_of(painted->picture.error().front());
        return;
    }
    auto texture = gpu::texture_of(**painted->picture, Format::rgba8, Encoding::display);
    if (!texture) {
        entry.problem = message_of(texture.error().front());
        return;
    }
    entry.picture.emplace(std::move(*texture));
}

namespace {
std::optional<Picture> in_optional(Picture picture) {
    return picture;
}
}  // namespace

// A cancelled picture stays due.
void PresetThumbnails::start(const Lab& lab) {
    std::vector<std::pair<fs::path, fs::file_time_type>> wanted;
    for (const auto& [file, entry] : m_entries)
        if (is_wanted(entry))
            wanted.emplace_back(file, entry.written);
    m_work.start([look = *m_look, content = m_content, library = lab.work().library,
                  wanted = std::move(wanted), basket = m_basket, draws = m_use == Use::drawn,
                  wake = m_wake](JobProgress& work) -> Result<bool> {
        PresetThumbnailRenderer painter(look, library, content);
        for (const auto& [file, written] : wanted) {
            const int before = painter.drawn();
            auto picture =
                draws ? painter.paint(file, work).map(in_optional) : painter.find_cached(file);
            if (work.is_cancelled)
                return true;
            {
                const std::lock_guard lock(basket->mutex);
                basket->painted.push_back({file, written, std::move(picture), painter.named_files(),
                                           painter.stamp(), painter.drawn() - before});
            }
            if (wake)
                wake();
        }
        return true;
    });
}

PresetThumbnails::Shown PresetThumbnails::of(const fs::path& preset) const {
    const auto found = m_entries.find(preset);
    if (found == m_entries.end())
        return {};
    const Entry& entry = found->second;
    Shown shown{{}, entry.problem, entry.is_due};
    if (entry.picture)
        shown.image = {entry.picture->handle(), entry.picture->extent()};
    return shown;
}
