#include "base/line_map.h"

#include <algorithm>
#include <cassert>

LineMap::LineMap(std::initializer_list<Location> lines) {
    for (const Location& at : lines)
        push_back(at);
}

void LineMap::append(const Location& first, std::size_t count) {
    if (count == 0)
        return;
    const std::size_t begin = size();
    std::vector<Stretch>& stretches = m_stretches.own();
    if (!stretches.empty()) {
        Stretch& last = stretches.back();
        const std::size_t last_begin =
            stretches.size() > 1 ? stretches[stretches.size() - 2].end : 0;
        const int next_line = last.first.line + static_cast<int>(last.end - last_begin);
        // Compared as text: a different spelling of the same path is kept.
        if (next_line == first.line && last.first.file.native() == first.file.native()) {
            last.end += count;
            return;
        }
    }
    stretches.push_back({first, begin + count});
}

Location LineMap::operator[](std::size_t index) const {
    assert(index < size());
    const auto in = std::upper_bound(
        m_stretches->begin(), m_stretches->end(), index,
        [](std::size_t wanted, const Stretch& stretch) { return wanted < stretch.end; });
    const std::size_t begin = in == m_stretches->begin() ? 0 : std::prev(in)->end;
    return {in->first.file, in->first.line + static_cast<int>(index - begin)};
}
