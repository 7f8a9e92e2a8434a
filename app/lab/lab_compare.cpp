// The part of Lab that shows another picture beside the present one, and keeps values in slots.
#include "lab/lab.h"
#include "model/look/value_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

const Slots& Lab::slots() const {
    static const Slots none;
    return m_document ? m_comparing.slots(m_document->look().id) : none;
}

bool Lab::is_in_slot(std::size_t number) const {
    const std::optional<Slot>& slot = slots().at(number);
    return slot && values_of(*slot, m_document->look()) ==
                       changed_values(m_document->look(), m_document->values());
}

void Lab::keep_in_slot(std::size_t number) {
    if (!m_document || m_document->is_restacking())
        return;  // names are about to change
    const Look& look = m_document->look();
    m_comparing.set_slot(
        look.id, number,
        Slot{m_document->preset_name(), changed_values(look, m_document->values())});
    m_messages.say(fmt::format("Stored in slot {}", slot_name(number)));
}

void Lab::recall_slot(std::size_t number) {
    if (!m_document || m_document->is_restacking())
        return;
    const std::optional<Slot>& slot = slots().at(number);
    if (!slot)
        return m_messages.say(fmt::format("Slot {} is empty", slot_name(number)));
    Preset preset = m_document->preset();
    preset.values = values_of(*slot, m_document->look());
    m_document->take(preset, fmt::format("Recall slot {}", slot_name(number)));
}

void Lab::empty_slot(std::size_t number) {
    if (m_document)
        m_comparing.set_slot(m_document->look().id, number, std::nullopt);
}

CompareMode Lab::compare_mode() const {
    return sides() ? m_comparing.chosen().mode : CompareMode::off;
}

std::optional<Sides> Lab::sides() const {
    const Comparison& chosen = m_comparing.chosen();
    if (!m_document || !m_comparing.is_wanted())
        return std::nullopt;
    if (chosen.other.kind != Other::Kind::file)
        return m_variant && m_renderer->variant() && !m_renderer->is_replaying_variant()
                   ? std::optional(m_variant->sides)
                   : std::nullopt;
    const auto& picture = m_comparing.reference().picture();
    if (!picture)
        return std::nullopt;
    std::string name = m_comparing.reference().file().filename().string();
    if (picture->extent != m_size.extent())
        name = fmt::format("{} · {} × {}, scaled", name, picture->extent.width,
                           picture->extent.height);
    return Sides{std::move(name), "Now", true};
}

// Says why when there is nothing.
bool Lab::find_other(Comparison& comparison) {
    if (comparison.other.kind == Other::Kind::file &&
        (m_comparing.reference().file() != comparison.other.file ||
         !m_comparing.reference().picture()) &&
        !m_messages.succeeded(m_comparing.reference().read(comparison.other.file)))
        return false;
    m_comparing.choose(comparison);
    const auto other = m_comparing.nearest_other(m_document->look(), m_document->values());
    if (!other) {
        m_messages.say(
            fmt::format("\"{}\" has no switch as_written, and all slots are empty. Store the "
                        "settings in a slot or choose an image file to compare with.",
                        m_document->look().name),
            true);
        return false;
    }
    comparison.other = *other;
    return true;
}

void Lab::compare(Comparison comparison) {
    if (!m_document)
        return;
    const Comparison before = m_comparing.chosen();
    const bool is_asked = comparison.mode != CompareMode::off || comparison.other != before.other;
    if (is_asked && !find_other(comparison)) {
        comparison.mode = CompareMode::off;
        comparison.other = before.other;
    }
    m_comparing.choose(comparison);
    watch_extra_files();
}

void Lab::set_compare_mode(CompareMode mode) {
    Comparison comparison = m_comparing.chosen();
    comparison.mode = mode;
    compare(comparison);
}

void Lab::compare_with(const Other& other) {
    Comparison comparison = m_comparing.chosen();
    if (other.kind == Other::Kind::slot && !slots().at(other.slot))
        return m_messages.say(
            fmt::format("Slot {} is empty. Store settings in it first.", slot_name(other.slot)));
    comparison.other = other;
    if (comparison.mode == CompareMode::off)
        comparison.mode = CompareMode::wipe;
    compare(comparison);
}

void Lab::compare_with_file(const fs::path& file) {
    std::error_code error;
    compare_with({Other::Kind::file, 0, fs::absolute(file, error)});
    const auto& picture = m_comparing.reference().picture();
    if (m_comparing.chosen().other.kind != Other::Kind::file || !picture)
        return;
    m_opened_files.add(file);
    const std::string name = file.filename().string();
    const Extent own = picture->extent;
    const Extent shown = m_size.extent();
    m_messages.say(own == shown
                       ? fmt::format("Comparing with \"{}\"", name)
                       : fmt::format("Comparing with \"{}\" ({} × {}, scaled to {} × {})", name,
                                     own.width, own.height, shown.width, shown.height));
}

// A picture that is no source for the look, or that takes the place of the one before.
bool Lab::is_reference_wanted() const {
    const bool is_compared = m_comparing.chosen().mode != CompareMode::off &&
                             m_comparing.chosen().other.kind == Other::Kind::file;
    return is_compared || m_document->look().driven_by != Driver::picture;
}

void Lab::flash(bool is_flashing) {
    if (!m_document || is_flashing == m_comparing.is_flashing())
        return;
    Comparison comparison = m_comparing.chosen();
    if (is_flashing && !find_other(comparison))
        return m_comparing.choose(comparison);
    m_comparing.choose(comparison);
    m_comparing.flash(is_flashing);
}

void Lab::reference_changed() {
    const fs::path file = m_comparing.reference().file();
    if (m_messages.succeeded(m_comparing.reference().read(file)))
        m_messages.withdraw(file.string());
}

// Every turn: the variant's values go with those of the document.
void Lab::follow_variant(double wall_seconds) {
    m_comparing.pass_time(wall_seconds);
    if (m_document->is_restacking())
        return;
    const Values& values = m_document->values();
    const Other& other = m_comparing.chosen().other;
    auto next = m_comparing.is_wanted() ? m_comparing.variant(other, m_document->look(), values)
                                        : std::nullopt;
    const bool is_lost = m_variant && !m_renderer->variant();  // no memory, which has been said
    if (is_lost || (!next && other.kind != Other::Kind::file)) {
        m_comparing.end();
        next.reset();
    }
    if (next && !m_constants.has_programs_for(*m_document, next->values))
        return;
    if (next == m_variant)
        return follow_variant_constants();
    const auto former = std::exchange(m_variant, std::move(next));
    if (!m_variant) {
        m_renderer->end_variant();
        m_variant_images.forget();
        return;
    }
    if (!former || !m_renderer->variant())
        return start_variant();
    follow_variant_constants();
    const std::vector<std::string> changed =
        changed_parameters(m_document->look(), former->values, m_variant->values);
    m_renderer->set_variant_values(m_variant->values);
    show_variant_images();
    m_drawn_extent = {};  // sizes may depend on values
    want(redraw_after(m_document->look(), changed));
}

void Lab::show_variant_images() {
    if (!m_variant || !m_renderer->variant())
        return;
    const auto watched = m_variant_images.files();
    m_messages.succeeded(m_variant_images.show(m_document->look(), m_variant->values, *m_renderer,
                                               Renderer::Whose::variant));
    if (m_variant_images.files() != watched)
        watch_extra_files();
}

// It needs all that the picture itself was given, and a past: the time of the picture waits for it.
void Lab::start_variant() {
    if (m_renderer->replay().is_running())
        want({{}, true});  // the picture's own past was being drawn
    if (!m_messages.succeeded(m_renderer->start_variant(m_variant->values)))
        return;
    follow_variant_constants();
    for (const auto& [name, texture] : m_images)
        m_renderer->set_image(name, texture);
    m_variant_images.forget();
    show_variant_images();
    m_messages.succeeded(m_drive.show_anew(m_player, *m_renderer));
    constexpr double patience_seconds = 1.0;
    constexpr double fewest = 4;
    const double all = std::max(m_document->look().settle_frames, 1);
    const double bearable = std::max(patience_seconds / m_renderer->frame_seconds(), fewest);
    const double frames = m_player.is_playing() ? std::min(all, bearable) : all;
    m_renderer->replay_variant(m_player, static_cast<std::size_t>(frames));
}
