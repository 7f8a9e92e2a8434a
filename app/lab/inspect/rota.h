#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

/// Whose turn it is of several things that show a picture and would cost too much all at once:
/// while the picture goes on changing one in turn, five times a second; each once more when it
/// rests.
class Rota {
public:
    /// So many there are from now on, and none has had its turn: they get it one after the other,
    /// without a pause.
    void restart(std::size_t count);
    std::size_t size() const { return m_count; }

    /// The one that is due; none: not yet, or nothing is new. To be asked every turn of the window
    /// with the number of the picture (Executor::picture_number) and the time.
    std::optional<std::size_t> due(std::uint64_t picture, double seconds);
    /// It had its turn, and that took `seconds_taken`: where it is slow, at most a tenth of the
    /// time goes into it.
    void done(double seconds, double seconds_taken = 0.0);
    /// Some would still be due while the picture rests.
    bool is_owing() const { return m_owed > 0; }

private:
    std::size_t m_count = 0;
    std::size_t m_next = 0;
    std::size_t m_new = 0;   // that never had a turn
    std::size_t m_owed = 0;  // that have not seen the present picture
    std::optional<std::uint64_t> m_picture;
    double m_changed = 0.0;  // s, when the picture last did
    double m_due = 0.0;      // s
};
