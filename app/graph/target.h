#pragma once

#include "base/diagnostic.h"
#include "gpu/canvas.h"
#include "model/plan.h"

#include <vector>

/// What a pass has drawn: this frame's picture and the former ones that some input still reads, in
/// a ring.
class Target {
public:
    /// All its pictures are zero.
    static Result<Target> make(const PlannedTarget& planned);

    const PlannedTarget& planned() const { return m_planned; }
    /// Of this frame, or of `frames_ago`, at most as many as it keeps.
    gpu::Canvas& canvas(int frames_ago = 0) { return m_slots[place_of(frames_ago)]; }
    const gpu::Canvas& canvas(int frames_ago = 0) const { return m_slots[place_of(frames_ago)]; }

    /// The current picture becomes the one of a frame ago; the oldest is drawn over next.
    void advance();
    void clear();
    /// It has been drawn into since it was empty.
    void note_drawn() { m_is_drawn = true; }
    bool is_drawn() const { return m_is_drawn; }
    /// After advance(): the last picture once more, as if it had been drawn again.
    void keep();
    /// Takes over the newest pictures of a target of the same size and format.
    void adopt(Target&& former);

private:
    std::size_t place_of(int frames_ago) const;

    PlannedTarget m_planned;
    std::vector<gpu::Canvas> m_slots;
    std::size_t m_current = 0;
    bool m_is_drawn = false;
};

/// Whether a target of one plan can go on in another: all but the number of its pictures is the
/// same.
bool is_compatible(const PlannedTarget& a, const PlannedTarget& b);
