#pragma once

#include "lab/frame/pass_control.h"
#include "lab/messages/choice.h"

#include <string>

/// Tells the user once per look that a pass takes too long for the window to respond, and what can
/// be done.
class HeavyPassNotice {
public:
    HeavyPassNotice(Workspace& work, const PassControl& passes) : m_work(work), m_passes(passes) {}

    /// The commands that help; empty while no pass takes too long.
    ChoiceList choices() const;
    /// After a frame. A pass counts as heavy until it takes half of the limit.
    void update();
    /// Another look is opened, or the look was edited.
    void reset();

private:
    void withdraw();

    Workspace& m_work;
    const PassControl& m_passes;
    std::string m_pass;  // "": none is heavy
    bool m_was_shown = false;
};
