#pragma once

#include "graph/programs/programs.h"

#include <cstddef>
#include <limits>

/// The programs of the passes of both, each once; no more than `most`.
Programs joined(Programs first, const std::vector<PassProgram>& others,
                std::size_t most = std::numeric_limits<std::size_t>::max());

/// The programs that a look was drawn with lately: a text that comes back, as undo brings it, needs
/// nothing of the driver.
class RecentPrograms {
public:
    /// They are drawn with from now on. What ends elsewhere is forgotten, and the oldest of what
    /// they do not use.
    void show(const Programs& programs);
    /// Those that are shown and, behind their passes, former ones, the newest first. Null: nothing
    /// is shown yet.
    const std::shared_ptr<const Programs>& all() const { return m_all; }

private:
    std::shared_ptr<const Programs> m_all;
};
