#pragma once

#include "base/diagnostic.h"
#include "gpu/objects/canvas.h"
#include "model/plan/plan.h"

#include <optional>
#include <string>
#include <vector>

/// The output of a pass: the picture of this frame and the previous ones that inputs still read, in
/// a ring. A frame that is drawn in slices has its own picture. Until it is complete, readers
/// outside the frame get the previous one.
class Target {
public:
    /// All pictures are initially zero.
    static Result<Target> make(const PlannedTarget& planned);

    const PlannedTarget& planned() const { return m_planned; }
    /// The picture of this frame or `frames_ago`, limited to the number that is kept.
    gpu::Canvas& canvas(int frames_ago = 0);
    const gpu::Canvas& canvas(int frames_ago = 0) const;

    /// As canvas() before begin(): never an unfinished picture.
    const gpu::Canvas& finished(int frames_ago = 0) const {
        return m_slots.empty() ? *m_shared : m_slots[slot_of(frames_ago)];
    }

    /// Whether canvas(1) is not the picture that is drawn into.
    bool has_previous() const {
        return m_slots.size() > 1 || (m_unfinished != Unfinished::no && m_spare);
    }

    /// The current picture becomes that of one frame ago. The oldest is overwritten next.
    void advance();
    void clear();
    /// Names all its pictures for debuggers.
    void set_label(const std::string& name);
    /// Records that it has been drawn into since the last clear().
    void note_drawn() { m_is_drawn = true; }
    bool is_drawn() const { return m_is_drawn; }
    /// After advance(): repeats the previous picture.
    void keep();
    /// Sets the common picture for the newest output; null: its own.
    void set_shared(gpu::Canvas* common) { m_shared = common; }
    /// Releases the common picture, which others may then overwrite. If it was drawn and previous
    /// pictures are kept, it is first swapped with the oldest.
    void release(bool is_drawn);

    /// Moves the newest pictures of a target of the same size and format here.
    void adopt(Target&& old);

    /// Copies the newest pictures of a target of the same format, stretched to this size.
    void adopt_stretched(Target& old);

    /// Starts an unfinished picture, which canvas() then counts from: the next one, or the current
    /// one again.
    enum class Unfinished { no, next, again };
    void begin(Unfinished unfinished) { m_unfinished = unfinished; }
    /// Allocates the unfinished picture. If memory is exhausted, it is drawn in place and visible
    /// meanwhile.
    void allocate_unfinished();
    /// Completes the unfinished picture.
    void finish();
    /// Drops the unfinished picture: the state is as before begin(), except for pictures drawn in
    /// place.
    void drop() {
        m_unfinished = Unfinished::no;
        m_is_newest_shared = false;
    }
    /// Drops the unfinished picture and frees its memory.
    void release_unfinished();

private:
    std::size_t slot_of(int frames_ago) const;
    void take_spare();

    PlannedTarget m_planned;
    std::vector<gpu::Canvas> m_slots;  // own pictures
    gpu::Canvas* m_shared = nullptr;
    bool m_is_newest_shared = false;
    std::size_t m_current = 0;
    std::optional<gpu::Canvas> m_spare;  // the unfinished picture
    Unfinished m_unfinished = Unfinished::no;
    bool m_is_drawn = false;
    std::string m_label;
};

/// Whether a target can adopt the pictures of the other: only the number of pictures may differ.
bool is_compatible(const PlannedTarget& a, const PlannedTarget& b);
