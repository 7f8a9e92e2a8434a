#pragma once

#include "gpu/name.h"

#include <array>
#include <optional>

namespace gpu {

void delete_query(GLuint id);

/// How long the GPU worked on what lies between begin and end. Never waits: the answer is some
/// frames old. Timers do not nest.
class Timer {
public:
    Timer();

    void begin();
    void end();
    /// The newest measure that has arrived.
    std::optional<double> milliseconds();

private:
    static constexpr std::size_t ring = 4;
    static GLuint new_query();

    void collect();

    std::array<Name<delete_query>, ring> m_queries;
    std::size_t m_begun = 0;  // so many queries were begun, from the first on
    std::size_t m_read = 0;   // so many of them were read
    bool m_is_open = false;
    std::optional<double> m_milliseconds;
};

}  // namespace gpu
