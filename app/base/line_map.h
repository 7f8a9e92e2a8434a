#pragma once

#include "base/diagnostic.h"
#include "base/shared.h"

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <vector>

/// The origin of each line of an assembled text: line n of the text is lines[n - 1]. Stored as
/// ranges, so memory grows with the number of includes, not of lines. Copies share the ranges.
class LineMap {
public:
    /// Consecutive lines of one file.
    struct Stretch {
        Location first;
        std::size_t end = 0;  // index into the map, past the last line

        bool operator==(const Stretch&) const = default;
    };

    LineMap() = default;
    LineMap(std::initializer_list<Location> lines);

    void push_back(const Location& at) { append(at, 1); }
    /// Appends `count` lines, starting at `first`.
    void append(const Location& first, std::size_t count);

    std::size_t size() const { return empty() ? 0 : m_stretches->back().end; }
    bool empty() const { return m_stretches->empty(); }
    Location operator[](std::size_t index) const;
    const std::vector<Stretch>& stretches() const { return *m_stretches; }

    bool operator==(const LineMap&) const = default;

private:
    Shared<std::vector<Stretch>> m_stretches;  // no empty ranges; adjacent ones are merged
};
