#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

/// Round-robin refresh of items that show the picture and are too expensive to update together.
/// While the picture changes, one item is updated five times a second. When it becomes static, each
/// item is updated once more.
class RoundRobin {
public:
    /// Starts with this number of new items. They are updated one after the other without a pause.
    void restart(std::size_t count);
    std::size_t size() const { return m_count; }

    /// The item to update now; nullopt: nothing to do yet. Call it in every update with
    /// FrameTextures::number() and the time.
    std::optional<std::size_t> due(std::uint64_t picture, double seconds);
    /// Reports the update of the due item, which took `seconds_taken`. Slow updates use at most a
    /// tenth of the time.
    void done(double seconds, double seconds_taken = 0.0);
    /// Whether some items do not show the current picture yet.
    bool is_pending() const { return m_pending > 0; }

private:
    std::size_t m_count = 0;
    std::size_t m_next = 0;
    std::size_t m_new = 0;      // never updated
    std::size_t m_pending = 0;  // do not show the current picture
    std::optional<std::uint64_t> m_picture;
    double m_changed = 0.0;  // s, of the last change
    double m_due = 0.0;      // s
};
