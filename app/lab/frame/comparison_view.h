#pragma once

#include "lab/compare/comparing.h"
#include "lab/frame/workspace.h"
#include "lab/reload/text_constants.h"

#include <optional>

/// Compares the picture with a reference: the article's picture, a slot of stored values, an image
/// file. Article and slots are drawn as a variant: the same look and frames with other values.
class ComparisonView {
public:
    ComparisonView(Workspace& work, const LookLoader& loader, TextConstants& constants)
        : m_work(work), m_loader(loader), m_constants(constants) {}

    /// The user's choice.
    const Comparing& selection() const { return m_selection; }
    /// How both pictures are displayed; off without a reference.
    CompareMode mode() const;
    /// The names of both; nullopt while the reference is not ready.
    std::optional<Sides> sides() const;

    /// Shows a notice with the reason if no reference is available.
    void choose(Comparison comparison);
    void set_mode(CompareMode mode);
    /// As a wipe if nothing was compared before.
    void compare_with(const Other& other);
    void compare_with_file(const std::filesystem::path& file);
    /// Shows the reference instead of the picture while this is on.
    void show_reference(bool is_reference_shown);
    /// Whether an opened picture file becomes the reference instead of the source.
    bool is_file_wanted() const;
    /// Reads the reference file again; false if it is another file.
    bool file_changed(const std::filesystem::path& file);

    /// The slots of the open look.
    const Slots& slots() const;
    void set_all_slots(LookSlots slots) { m_selection.set_slots(std::move(slots)); }
    /// Whether a slot holds the current values.
    bool is_in_slot(std::size_t number) const;
    void store(std::size_t number);
    void recall(std::size_t number);  // one undo step
    void clear_slot(std::size_t number);

    /// Call before a frame is drawn: starts, changes or ends the variant. Returns whether its
    /// values changed.
    bool update(double wall_seconds);
    /// Uploads the chosen pictures of the variant.
    void show_pictures();
    /// The values of the variant, without modulation; null: no variant.
    const Values* variant_values() const { return m_variant ? &m_variant->values : nullptr; }
    /// Call when a look is opened. `is_same`: the same look with another preset.
    void open(bool is_same);

private:
    bool find_other(Comparison& comparison);
    void start_variant();
    void update_constants();

    Workspace& m_work;
    const LookLoader& m_loader;
    TextConstants& m_constants;
    Comparing m_selection;
    std::optional<Variant> m_variant;  // drawn by the renderer
};
