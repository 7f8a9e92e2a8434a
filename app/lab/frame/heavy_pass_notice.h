#pragma once

#include "lab/frame/pass_control.h"
#include "lab/messages/menu_entry.h"

#include <string>

/// Shows a notice once per look if a pass takes too long for the window to respond, with possible
/// actions.
class HeavyPassNotice {
public:
    HeavyPassNotice(Workspace& work, const PassControl& passes) : m_work(work), m_passes(passes) {}

    /// The possible actions; empty while no pass takes too long.
    MenuSection section() const;
    /// Call after a frame. A pass counts as heavy until it takes less than half of the limit.
    void update();
    /// Call when another look is opened, or the look was edited.
    void reset();

private:
    void withdraw();

    Workspace& m_work;
    const PassControl& m_passes;
    std::string m_pass;  // "": none is heavy
    bool m_was_shown = false;
};
