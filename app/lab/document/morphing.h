#pragma once

#include "lab/document/document.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

/// An animation from the current values to a preset's, as one undo step. At its end the preset is
/// open. Locked parameters are unchanged. A change by the user ends the morph.
class Morphing {
public:
    /// `to` is a preset of the document's look with valid values; its name is displayed. `file` "":
    /// the look without a preset.
    Morphing(const Document& document, Preset to, std::filesystem::path file, double seconds);

    /// Advances the morph; false when it has ended.
    bool update(Document& document, double seconds);
    double share() const { return m_elapsed / m_seconds; }
    const std::string& name() const { return m_to.name; }
    const std::filesystem::path& file() const { return m_file; }
    /// The name of its undo step.
    std::string step_name() const { return fmt::format("Morph to {}", name()); }
    bool is_finished() const { return m_elapsed >= m_seconds; }

private:
    std::string m_look;
    Preset m_to;
    std::filesystem::path m_file;
    Values m_from;
    Values m_goal;
    Values m_last;
    double m_seconds = 1.0;
    double m_elapsed = 0.0;
};
