#pragma once

#include "lab/document.h"

#include <string>

/// A way from the present values to a preset's, over some time, as one step of undo. What is locked
/// stays; what somebody turns meanwhile ends it there.
class Morphing {
public:
    /// `name` is the preset's.
    Morphing(const Document& document, std::string name, const Values& to, double seconds);

    /// Goes on; false when it has ended.
    bool go_on(Document& document, double seconds);
    double share() const { return m_elapsed / m_seconds; }
    const std::string& name() const { return m_name; }
    /// Of its step of undo.
    std::string step_name() const { return "Morph to " + m_name; }
    bool changes_anything() const { return m_from != m_to; }
    bool has_arrived() const { return m_elapsed >= m_seconds; }

private:
    std::string m_look;
    std::string m_name;
    Values m_from;
    Values m_to;
    Values m_last;
    double m_seconds = 1.0;
    double m_elapsed = 0.0;
};
