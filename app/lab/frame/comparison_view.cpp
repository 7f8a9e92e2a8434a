#include "lab/frame/comparison_view.h"

#include "formats/preset/fitted_preset.h"
#include "formats/preset/preset_format.h"
#include "lab/document/opened_preset.h"
#include "lab/library/named_preset.h"
#include "model/look/value_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

const Slots& ComparisonView::slots() const {
    static const Slots none;
    return m_work.document ? m_selection.slots(m_work.document->look().id) : none;
}

bool ComparisonView::is_in_slot(std::size_t number) const {
    const std::optional<Slot>& slot = slots().at(number);
    return slot && values_of(*slot, m_work.document->look()) ==
                       changed_values(m_work.document->look(), m_work.document->values());
}

void ComparisonView::store(std::size_t number) {
    if (!m_work.document || m_work.document->has_pending_stack())
        return;  // names are about to change
    const Look& look = m_work.document->look();
    m_selection.set_slot(
        look.id, number,
        Slot{preset_name(*m_work.document), changed_values(look, m_work.document->values())});
    m_work.messages.say(fmt::format("Stored in slot {}", slot_name(number)));
}

namespace {
// The preset that was open when the slot was stored. If it can't be read any more, only its name:
// saving must not overwrite the preset that is open now.
OpenedPreset preset_of_slot(const Slot& slot, const Document& document, const Library& library) {
    Document other = document;
    if (slot.preset.empty()) {
        open_defaults(other);
        return opened_preset(other);
    }
    const auto file = find_named_preset(library, document.look().id, slot.preset);
    const auto preset = file && !file->empty() ? load_preset(*file) : fail(Diagnostics{});
    if (!preset) {
        OpenedPreset lost{.saved = initial_state(document.look())};
        lost.identity.name = slot.preset;
        return lost;
    }
    Diagnostics warnings;  // reported when the preset is opened
    open_preset(other, fitted_preset(document.look(), *preset, *file, warnings), *file);
    return opened_preset(other);
}
}  // namespace

void ComparisonView::recall(std::size_t number) {
    if (!m_work.document || m_work.document->has_pending_stack())
        return;
    const std::optional<Slot>& slot = slots().at(number);
    if (!slot)
        return m_work.messages.say(fmt::format("Slot {} is empty", slot_name(number)));
    Preset preset = preset_of(*m_work.document);
    preset.values = values_of(*slot, m_work.document->look());
    const auto stored = preset_of_slot(*slot, *m_work.document, m_work.library);
    apply_preset(*m_work.document, preset, fmt::format("Recall slot {}", slot_name(number)));
    if (stored.identity.name != preset_name(*m_work.document))
        base_on(*m_work.document, stored);
}

void ComparisonView::clear_slot(std::size_t number) {
    if (m_work.document)
        m_selection.set_slot(m_work.document->look().id, number, std::nullopt);
}

CompareMode ComparisonView::mode() const {
    return sides() ? m_selection.chosen().mode : CompareMode::off;
}

std::optional<Sides> ComparisonView::sides() const {
    const Comparison& chosen = m_selection.chosen();
    if (!m_work.document || !m_selection.is_wanted())
        return std::nullopt;
    if (chosen.other.kind != Other::Kind::file)
        return m_variant && m_work.renderer->executors().variant() &&
                       !m_work.renderer->replay().is_of_variant()
                   ? std::optional(m_variant->sides)
                   : std::nullopt;
    const auto& picture = m_selection.reference().picture();
    if (!picture)
        return std::nullopt;
    std::string name = m_selection.reference().file().filename().string();
    if (picture->extent != m_work.size.extent())
        name = fmt::format("{} · {} × {}, scaled", name, picture->extent.width,
                           picture->extent.height);
    return Sides{std::move(name), "Now", true};
}

bool ComparisonView::find_other(Comparison& comparison) {
    if (comparison.other.kind == Other::Kind::file &&
        (m_selection.reference().file() != comparison.other.file ||
         !m_selection.reference().picture()) &&
        !m_work.messages.succeeded(m_selection.reference().read(comparison.other.file)))
        return false;
    m_selection.choose(comparison);
    const auto other =
        m_selection.nearest_other(m_work.document->look(), m_work.document->values());
    if (!other) {
        m_work.messages.say(
            fmt::format("\"{}\" has no switch as_written, and all slots are empty. Store the "
                        "settings in a slot or choose an image file to compare with.",
                        m_work.document->look().name),
            true);
        return false;
    }
    comparison.other = *other;
    return true;
}

void ComparisonView::choose(Comparison comparison) {
    if (!m_work.document)
        return;
    const Comparison before = m_selection.chosen();
    const bool is_asked = comparison.mode != CompareMode::off || comparison.other != before.other;
    if (is_asked && !find_other(comparison)) {
        comparison.mode = CompareMode::off;
        comparison.other = before.other;
    }
    m_selection.choose(comparison);
}

void ComparisonView::set_mode(CompareMode mode) {
    Comparison comparison = m_selection.chosen();
    comparison.mode = mode;
    choose(comparison);
}

void ComparisonView::compare_with(const Other& other) {
    Comparison comparison = m_selection.chosen();
    if (other.kind == Other::Kind::slot && !slots().at(other.slot))
        return m_work.messages.say(
            fmt::format("Slot {} is empty. Store settings in it first.", slot_name(other.slot)));
    comparison.other = other;
    if (comparison.mode == CompareMode::off)
        comparison.mode = CompareMode::wipe;
    choose(comparison);
}

void ComparisonView::compare_with_file(const fs::path& file) {
    std::error_code error;
    compare_with({Other::Kind::file, 0, fs::absolute(file, error)});
    const auto& picture = m_selection.reference().picture();
    if (m_selection.chosen().other.kind != Other::Kind::file || !picture)
        return;
    m_work.opened_files.add(file);
    const std::string name = file.filename().string();
    const Extent own = picture->extent;
    const Extent shown = m_work.size.extent();
    m_work.messages.say(own == shown
                            ? fmt::format("Comparing with \"{}\"", name)
                            : fmt::format("Comparing with \"{}\" ({} × {}, scaled to {} × {})",
                                          name, own.width, own.height, shown.width, shown.height));
}

bool ComparisonView::is_file_wanted() const {
    const bool is_compared = m_selection.chosen().mode != CompareMode::off &&
                             m_selection.chosen().other.kind == Other::Kind::file;
    const Look& look = m_work.document->look();
    return is_compared || (look.driven_by != Driver::picture && !look.has_other_driver);
}

void ComparisonView::show_reference(bool is_reference_shown) {
    if (!m_work.document || is_reference_shown == m_selection.is_reference_shown())
        return;
    Comparison comparison = m_selection.chosen();
    if (is_reference_shown && !find_other(comparison))
        return m_selection.choose(comparison);
    m_selection.choose(comparison);
    m_selection.show_reference(is_reference_shown);
}

bool ComparisonView::file_changed(const fs::path& file) {
    if (file != m_selection.reference().file())
        return false;
    if (m_work.messages.succeeded(m_selection.reference().read(file)))
        m_work.messages.withdraw(file.string());
    return true;
}

void ComparisonView::open(bool is_same) {
    m_variant.reset();
    if (!is_same)
        m_selection.end();
}

bool ComparisonView::update(double wall_seconds) {
    m_selection.update(wall_seconds);
    if (m_work.document->has_pending_stack())
        return false;
    const Look& look = m_work.document->look();
    const Other& other = m_selection.chosen().other;
    auto next = m_selection.is_wanted()
                    ? m_selection.variant(other, look, m_work.document->values())
                    : std::nullopt;
    const bool is_lost =
        m_variant && !m_work.renderer->executors().variant();  // out of memory, which was reported
    if (is_lost || (!next && other.kind != Other::Kind::file)) {
        m_selection.end();
        next.reset();
    }
    if (next && !m_constants.has_programs_for(*m_work.document, next->values))
        return false;
    if (next == m_variant) {
        update_constants();
        return false;
    }
    const auto previous = std::exchange(m_variant, std::move(next));
    if (!m_variant) {
        m_work.renderer->executors().end_variant();
        m_work.pictures.clear_variant();
        return false;
    }
    if (!previous || !m_work.renderer->executors().variant()) {
        start_variant();
        return false;
    }
    update_constants();
    m_work.renderer->executors().variant()->set_values(m_variant->values);
    show_pictures();
    m_work.redraw.add(
        redraw_after(look, changed_parameters(look, previous->values, m_variant->values)));
    return true;
}

void ComparisonView::show_pictures() {
    if (m_variant)
        m_work.messages.succeeded(m_work.pictures.show_variant(
            m_work.document->look(), m_variant->values, m_work.renderer->executors()));
}

// The variant needs all inputs of the picture, and its past. The clock waits for it.
void ComparisonView::start_variant() {
    if (m_work.renderer->replay().is_running())
        m_work.redraw.add_replay();  // the running replay was for the picture
    if (!m_work.messages.succeeded(m_work.renderer->executors().start_variant(m_variant->values)))
        return;
    const Look& look = m_work.document->look();
    update_constants();
    m_work.messages.succeeded(
        m_work.pictures.show_new_variant(look, m_variant->values, m_work.renderer->executors()));
    m_work.messages.succeeded(m_work.media.source().show_again(m_work.player.transport().time(),
                                                               m_work.renderer->executors()));
    constexpr double sample_budget_seconds = 1.0;
    constexpr double fewest = 4;
    const double all = std::max(look.settle_frames, 1);
    const double bearable =
        std::max(sample_budget_seconds / m_work.renderer->times().frame_seconds(), fewest);
    const double frames = m_work.player.transport().is_playing() ? std::min(all, bearable) : all;
    m_work.renderer->replay().start_variant(m_work.player, static_cast<std::size_t>(frames));
}

// The picture may have new programs, or those for the variant may be ready.
void ComparisonView::update_constants() {
    if (!m_variant || !m_work.renderer->executors().variant())
        return;
    const Look& look = m_work.document->look();
    const Values wanted = constants_of(look, m_variant->values);
    const Look& drawn = m_work.renderer->executors().variant()->look();
    if (drawn.constants == wanted ||
        !m_constants.has_programs_for(*m_work.document, m_variant->values))
        return;
    const bool is_as_picture = wanted == look.constants;
    const Look next = with_overrides(is_as_picture ? look : m_constants.variant()->look,
                                     m_work.document->state().overrides);
    const Programs& programs =
        is_as_picture ? m_loader.programs().generic() : m_constants.variant()->programs;
    m_work.renderer->drop_frame();
    if (m_work.messages.succeeded(m_work.renderer->executors().variant()->replace(next, programs)))
        m_work.redraw.add_replay();
    else
        m_work.renderer->executors().end_variant();
}
