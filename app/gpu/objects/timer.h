#pragma once

#include "gpu/objects/name.h"

#include <array>
#include <optional>

namespace gpu {

void delete_query(GLuint id);

/// How long the GPU worked on what lies between begin and end. Never waits: the answer is some
/// frames old. Timers do not nest.
class Timer {
public:
    Timer();

    /// `parts`: how many equal pieces of work follow.
    void begin(int parts = 1);
    void end();
    /// What somebody else measured, in place of begin and end; of work in `parts` equal pieces.
    void tell(double milliseconds, int parts = 1);
    /// The newest measure that has arrived, of the whole and of one of its parts; never the first.
    std::optional<double> milliseconds();
    std::optional<double> milliseconds_a_part();

private:
    static constexpr std::size_t ring = 4;
    static GLuint new_query();

    void collect();

    std::array<Name<delete_query>, ring> m_queries;
    std::size_t m_begun = 0;  // so many queries were begun, from the first on
    std::size_t m_read = 0;   // so many of them were read
    std::array<int, ring> m_parts{};
    bool m_is_open = false;
    std::optional<double> m_milliseconds;
    int m_measured_parts = 1;
};

}  // namespace gpu
