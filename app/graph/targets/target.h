#pragma once

#include "base/diagnostic.h"
#include "gpu/objects/canvas.h"
#include "model/plan/plan.h"

#include <optional>
#include <vector>

/// What a pass has drawn: this frame's picture and the former ones that some input still reads, in
/// a ring. A frame that is drawn in slices goes into a picture of its own: until it is whole, who
/// looks on from outside is shown the one before.
class Target {
public:
    /// All its pictures are zero.
    static Result<Target> make(const PlannedTarget& planned);

    const PlannedTarget& planned() const { return m_planned; }
    /// Of this frame, or of `frames_ago`, at most as many as it keeps.
    gpu::Canvas& canvas(int frames_ago = 0);
    const gpu::Canvas& canvas(int frames_ago = 0) const;

    /// What canvas() was before an unfinished picture was begun.
    const gpu::Canvas& finished(int frames_ago = 0) const {
        return m_slots.empty() ? *m_lent : m_slots[place_of(frames_ago)];
    }

    /// Whether canvas(1) is another than what is drawn into.
    bool has_former() const {
        return m_slots.size() > 1 || (m_unfinished != Unfinished::no && m_spare);
    }

    /// The current picture becomes the one of a frame ago; the oldest is drawn over next.
    void advance();
    void clear();
    /// It has been drawn into since it was empty.
    void note_drawn() { m_is_drawn = true; }
    bool is_drawn() const { return m_is_drawn; }
    /// After advance(): the last picture once more, as if it had been drawn again.
    void keep();
    /// Where the newest picture is drawn, if it has one in common with others; null: in its own.
    void lend(gpu::Canvas* common) { m_lent = common; }
    /// What others may draw over from now on is given back: the newest picture of this frame, if it
    /// was drawn, changes places with the oldest one, where former ones are kept.
    void hand_back(bool is_drawn);

    /// Takes over the newest pictures of a target of the same size and format.
    void adopt(Target&& former);

    /// Takes over the newest pictures of a target of the same format, stretched to its own size.
    void adopt_stretched(Target& former);

    /// From here on canvas() counts from a picture that is not whole yet: the next one, or the
    /// present one once more.
    enum class Unfinished { no, next, again };
    void begin(Unfinished unfinished) { m_unfinished = unfinished; }
    /// Makes room for it before it is drawn. Without memory it is drawn where it will stay, and
    /// seen meanwhile.
    void make_room();
    /// It is whole.
    void finish();
    /// It never will be: all is as before begin(), except for what had to be drawn in its place.
    void drop() {
        m_unfinished = Unfinished::no;
        m_is_newest_lent = false;
    }
    /// Gives back what make_room() took.
    void forget_room();

private:
    std::size_t place_of(int frames_ago) const;
    void take_spare();

    PlannedTarget m_planned;
    std::vector<gpu::Canvas> m_slots;  // its own
    gpu::Canvas* m_lent = nullptr;
    bool m_is_newest_lent = false;
    std::size_t m_current = 0;
    std::optional<gpu::Canvas> m_spare;  // the unfinished picture
    Unfinished m_unfinished = Unfinished::no;
    bool m_is_drawn = false;
};

/// Whether a target of one plan can go on in another: all but the number of its pictures is the
/// same.
bool is_compatible(const PlannedTarget& a, const PlannedTarget& b);
