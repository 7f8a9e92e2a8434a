#pragma once

#include "lab/document/document.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

/// A way from the present values to a preset's, over some time, as one step of undo; at its end
/// the preset is open. What is locked stays; what somebody turns meanwhile ends it there.
class Morphing {
public:
    /// `to` is a preset of the document's look, with values that fit it; its name is shown. `file`
    /// "": the look as it is, without a preset.
    Morphing(const Document& document, Preset to, std::filesystem::path file, double seconds);

    /// Goes on; false when it has ended.
    bool go_on(Document& document, double seconds);
    double share() const { return m_elapsed / m_seconds; }
    const std::string& name() const { return m_to.name; }
    const std::filesystem::path& file() const { return m_file; }
    /// Of its step of undo.
    std::string step_name() const { return fmt::format("Morph to {}", name()); }
    bool has_arrived() const { return m_elapsed >= m_seconds; }

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
