#pragma once

#include "base/diagnostic.h"
#include "base/shared.h"

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <vector>

/// Where each line of an assembled text was written: line n of the text is lines[n - 1]. Kept as
/// stretches, so that it is as large as the text has includes, not as it has lines; copies share
/// them.
class LineMap {
public:
    /// Lines that follow each other in one file.
    struct Stretch {
        Location first;
        std::size_t end = 0;  // index into the map, past the last line

        bool operator==(const Stretch&) const = default;
    };

    LineMap() = default;
    LineMap(std::initializer_list<Location> lines);

    void push_back(const Location& at) { append(at, 1); }
    /// `count` lines, from `first` on.
    void append(const Location& first, std::size_t count);

    std::size_t size() const { return empty() ? 0 : m_stretches->back().end; }
    bool empty() const { return m_stretches->empty(); }
    Location operator[](std::size_t index) const;
    const std::vector<Stretch>& stretches() const { return *m_stretches; }

    bool operator==(const LineMap&) const = default;

private:
    Shared<std::vector<Stretch>> m_stretches;  // none empty, none that could be one with the next
};
