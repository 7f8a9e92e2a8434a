#include "graph/programs/recent_programs.h"

#include <algorithm>

namespace {
constexpr std::size_t most_former = 16;
}

Programs joined(Programs first, const std::vector<PassProgram>& others, std::size_t most) {
    for (const PassProgram& other : others) {
        if (first.passes.size() >= most)
            break;
        const auto same = std::ranges::find(first.passes, other.program, &PassProgram::program);
        if (same == first.passes.end())
            first.passes.push_back(other);
    }
    return first;
}

void RecentPrograms::show(const Programs& programs) {
    const bool ends_here = m_all && m_all->home == programs.home;
    m_all = std::make_shared<const Programs>(
        joined(programs, ends_here ? m_all->passes : std::vector<PassProgram>(),
               programs.passes.size() + most_former));
}
