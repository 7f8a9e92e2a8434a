// The part of Lab that shows other values beside the present ones.
#include "lab/lab.h"

#include <algorithm>
#include <utility>

void Lab::set_wiping(bool is_wiping) {
    m_is_wiping = is_wiping && m_document;
    if (m_is_wiping && !article_variant(m_document->look(), m_document->values())) {
        m_is_wiping = false;
        say("'" + m_document->look().name +
                "' has no switch 'as_written': there is no other picture to wipe to",
            true);
    }
}

// Every turn: the variant's values go with those of the document.
void Lab::follow_variant() {
    if (m_document->is_restacking())
        return;
    const Values& values = m_document->values();
    auto next = m_is_wiping ? article_variant(m_document->look(), values) : std::nullopt;
    if (m_variant && !m_renderer->variant()) {  // it could not be drawn, which has been said
        m_is_wiping = false;
        next.reset();
    }
    if (next == m_variant)
        return;
    const auto former = std::exchange(m_variant, std::move(next));
    if (!m_variant) {
        m_renderer->end_variant();
        return;
    }
    if (!former || !m_renderer->variant())
        return start_variant();
    std::vector<std::string> changed;
    for (const Parameter& parameter : m_document->look().parameters)
        if (value_of(parameter, former->values) != value_of(parameter, m_variant->values))
            changed.push_back(parameter.name);
    m_renderer->set_variant_values(m_variant->values);
    m_drawn_extent = {};  // sizes may depend on values
    want(redraw_after(m_document->look(), changed));
}

// It needs all that the picture itself was given, and a past: the time of the picture waits for it.
void Lab::start_variant() {
    if (m_renderer->replay().is_running())
        want({{}, true});  // the picture's own past was being drawn
    if (!succeeded(m_renderer->start_variant(m_variant->values)))
        return;
    for (const auto& [name, picture] : m_images)
        succeeded(m_renderer->set_image(name, *picture));
    m_chosen_images.forget();
    succeeded(m_chosen_images.show(m_document->look(), m_variant->values, *m_renderer));
    succeeded(m_drive.show_anew(m_player, *m_renderer));
    constexpr double patience_seconds = 1.0;
    constexpr double fewest = 4;
    const double all = std::max(m_document->look().settle_frames, 1);
    const double bearable = std::max(patience_seconds / m_renderer->frame_seconds(), fewest);
    const double frames = m_player.is_playing() ? std::min(all, bearable) : all;
    m_renderer->replay_variant(m_player, static_cast<std::size_t>(frames));
}
