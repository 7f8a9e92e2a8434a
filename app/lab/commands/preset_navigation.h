#pragma once

#include "lab/commands/content_commands.h"
#include "lab/document/morphing.h"
#include "lab/frame/workspace.h"
#include "lab/library/preset_cycle.h"
#include "lab/reload/look_loader.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Next, previous and favourite presets, opened immediately or morphed to.
class PresetNavigation {
public:
    PresetNavigation(Workspace& work, LookLoader& loader, ContentCommands& content)
        : m_work(work), m_loader(loader), m_content(content) {}

    const FavouritePresets& stars() const { return m_stars; }
    FavouritePresets& stars() { return m_stars; }
    /// `preset` is the id of a preset of the open look.
    void star(const std::string& preset, bool has_star);

    /// Opens the preset `by` entries further in the list of the open look, or of its favourites. If
    /// the last step has not opened yet, continues from its preset.
    void step(int by, bool only_starred = false);
    /// Opens a preset by name, see find_named_preset(). With `seconds`, morphs to it if it belongs
    /// to the open look.
    Result<void> open_named(const std::string& name, std::optional<double> seconds = {});
    /// The names of the presets of the open look, in the order of the list.
    std::vector<std::string> names() const;
    /// Morphs to a preset of the open look, as one undo step, and opens it at the end; "": to the
    /// look's defaults.
    Result<void> morph_to(const std::filesystem::path& preset, double seconds);
    void morph_by(int by, double seconds, bool only_starred = false);
    void end_morph();
    /// The running morph, or null.
    const Morphing* morphing() const { return m_morphing.get(); }

    /// Advances the morph.
    void update(double wall_seconds);
    /// Call when a look or preset was opened: shows its name after a step, and how to restore
    /// unsaved changes that it replaced.
    void note_opened(const OpenRequest& request, bool had_changes);

private:
    std::optional<PresetIndex> target(int by, bool only_starred);

    Workspace& m_work;
    LookLoader& m_loader;
    ContentCommands& m_content;
    FavouritePresets m_stars;
    std::unique_ptr<Morphing> m_morphing;
    std::optional<PresetIndex> m_step;  // the preset that is being opened
    bool m_steps_favourites = false;    // its index counts favourites
};
