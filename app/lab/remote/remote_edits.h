#pragma once

#include "lab/document/document.h"

#include <map>
#include <string>

/// A parameter change from another program or device.
struct RemoteChange {
    std::string parameter;
    Value value;
};

/// Groups changes into undo steps. Changes of a parameter less than 0.5 s apart are one step.
class RemoteGesture {
public:
    /// Whether a change of the parameter belongs to the current step.
    bool continues_step(const std::string& parameter, double now_seconds);
    /// Whether the current step has ended; true only once.
    bool has_ended(double now_seconds);
    bool is_open() const { return !m_touched.empty(); }

private:
    std::map<std::string, double> m_touched;  // time of the last change in this step
};

/// Applies remote changes from OSC and MIDI to the document. Times are from a clock that never
/// stops.
class RemoteEdits {
public:
    /// Fails for locked parameters.
    Result<void> apply(Document& document, const RemoteChange& change, double now_seconds);
    /// Call it in every update after the messages. It ends undo steps.
    void update(Document* document, double now_seconds);
    /// Whether an undo step is still open.
    bool is_in_gesture() const { return m_gesture.is_open(); }

private:
    RemoteGesture m_gesture;
};
