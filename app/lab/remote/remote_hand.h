#pragma once

#include "lab/document/document.h"

#include <map>
#include <string>

/// What another program or a device asks of a look.
struct RemoteTurn {
    std::string parameter;
    Value value;
};

/// Says which changes that come one by one are one step of undo: those of a parameter with less
/// than half a second between them.
class RemoteGesture {
public:
    /// Whether a change of the parameter now goes on with the step that is open.
    bool goes_on(const std::string& parameter, double now_seconds);
    /// Whether the step that is open has come to its end; told once.
    bool has_ended(double now_seconds);
    bool is_open() const { return !m_touched.empty(); }

private:
    std::map<std::string, double> m_touched;  // when, of the step that is open
};

/// The one hand of all programs and devices that turn parameters: from here on it is the same
/// whether a number came by OSC or MIDI. Times are of a clock that never rests.
class RemoteHand {
public:
    /// Refused for what is locked.
    Result<void> turn(Document& document, const RemoteTurn& turn, double now_seconds);
    /// To be called every turn, after what has come: ends a step of undo.
    void update(Document* document, double now_seconds);
    /// A step of undo waits for its end.
    bool is_turning() const { return m_gesture.is_open(); }

private:
    RemoteGesture m_gesture;
};
