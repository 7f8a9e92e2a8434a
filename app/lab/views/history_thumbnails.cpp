#include "lab/views/history_thumbnails.h"

#include "lab/document/history.h"
#include "lab/lab.h"

#include <algorithm>

bool is_copy_due(int frame) {
    constexpr int last = 128;
    return frame >= 1 && frame <= last && (frame & (frame - 1)) == 0;
}

std::size_t farthest_index(const std::vector<std::size_t>& indices, std::size_t current) {
    const auto distance = [current](std::size_t index) {
        return index > current ? index - current : current - index;
    };
    return *std::max_element(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
        return distance(a) < distance(b);
    });
}

void HistoryThumbnails::update(const Lab& lab, Views& views) {
    const Document* document = lab.document();
    if (!document || !lab.renderer() || lab.loader().is_loading() ||
        document->has_pending_stack() || document->history().is_in_gesture() ||
        lab.renderer()->replay().is_running() || lab.frames().has_unfinished_frame() ||
        !lab.renderer()->has_whole_picture() || lab.renderer()->executor().plan().targets.empty())
        return;
    if (m_current != document->state()) {
        m_current = document->state();
        m_frames = 0;
    }
    constexpr int enough = 1 << 20;
    m_frames = std::min(m_frames + 1, enough);
    if (is_copy_due(m_frames))
        copy(lab, views, history_index(*document));
}

// Without memory a step has no picture.
void HistoryThumbnails::copy(const Lab& lab, Views& views, std::size_t index) {
    constexpr int height = 72;
    const Executor& executor = lab.renderer()->executor();
    const int last = static_cast<int>(executor.look().passes.size()) - 1;
    const Extent whole = executor.target(last).extent();
    const Extent small{
        std::clamp(height * whole.width / std::max(whole.height, 1), height / 2, height * 5 / 2),
        height};
    auto picture = views.thumbnail(lab, last, small);
    if (!picture)
        return;
    m_copies.insert_or_assign(index, Copy{*m_current, std::move(*picture)});
    forget_far(index);
}

void HistoryThumbnails::forget_far(std::size_t index) {
    constexpr std::size_t maximum = 64;  // about 2 MB
    if (m_copies.size() <= maximum)
        return;
    std::vector<std::size_t> indices;
    for (const auto& [at, copy] : m_copies)
        indices.push_back(at);
    m_copies.erase(farthest_index(indices, index));
}

ViewImage HistoryThumbnails::picture(const Document& document, std::size_t index) const {
    const auto found = m_copies.find(index);
    if (found == m_copies.end() || found->second.state != history_state(document, index))
        return {};
    return image_of(&found->second.picture);
}
