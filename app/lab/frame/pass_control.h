#pragma once

#include "lab/frame/workspace.h"
#include "lab/reload/specialization.h"
#include "model/plan/pass_switches.h"

#include <string>
#include <vector>

/// Bypass, solo, stop and freeze of passes, and their history.
class PassControl {
public:
    PassControl(Workspace& work, Specialization& specialization)
        : m_work(work), m_specialization(specialization) {}

    /// Of the open look; empty after another look has opened.
    const PassSwitches& switches() const { return m_switches; }
    /// Turns a switch of a pass on or off.
    void toggle(PassSwitch which, const std::string& pass);
    /// Applies switches. In a paused picture, affected passes are redrawn.
    void set(const PassSwitches& switches);
    /// Call after the renderer's look was replaced.
    void apply() { set(m_switches); }
    /// Call when another look is opened.
    void reset() { m_switches = {}; }
    /// Clears the history of a pass, even if it is frozen.
    void clear_history(const std::string& pass);
    void clear_history();  // of all passes
    /// The index of the pass that is displayed as the picture; 0 if no look is open.
    int picture_pass() const;

private:
    Result<void> set_runs(const std::vector<PassRun>& runs);
    void clear(const std::vector<bool>& passes);

    Workspace& m_work;
    Specialization& m_specialization;
    PassSwitches m_switches;
};
