#pragma once

#include "gpu/objects/name.h"

#include <array>
#include <optional>

namespace gpu {

void delete_query(GLuint id);

/// GPU time of the commands between begin and end. Never waits: the result is some frames old.
/// Timers do not nest.
class Timer {
public:
    Timer();

    /// `parts`: the number of equal pieces of work that follow.
    void begin(int parts = 1);
    void end();
    /// Sets a time measured elsewhere, instead of begin and end, for work in `parts` equal pieces.
    void set_elapsed(double milliseconds, int parts = 1);
    /// The newest result, of the whole and per part; the first measurement is skipped.
    std::optional<double> milliseconds();
    std::optional<double> milliseconds_per_part();

private:
    static constexpr std::size_t ring = 4;
    static GLuint new_query();

    void collect();

    std::array<Name<delete_query>, ring> m_queries;
    std::size_t m_begun = 0;  // number of queries begun since construction
    std::size_t m_read = 0;   // number of queries read
    std::array<int, ring> m_parts{};
    bool m_is_open = false;
    std::optional<double> m_milliseconds;
    int m_measured_parts = 1;
};

}  // namespace gpu
