#pragma once

#include "lab/document/document.h"
#include "lab/drawing/stroke_grip.h"

#include <optional>

/// What the left button does on the picture while the pen is in the hand.
enum class PenTool { freehand, points, edit, erase };

struct Pen {
    bool is_in_hand = false;
    PenTool tool = PenTool::freehand;
    bool is_smooth = true;  // what is drawn next

    bool operator==(const Pen&) const = default;
};

/// Drawing by hand. The drawing is a setting of the document's signal; here are the pen, the
/// keyframe that it draws on, and the line that is under way.
class DrawingBoard {
public:
    /// What the document's signal draws; none when that is not drawn by hand.
    const std::optional<Drawing>& drawing() const { return m_drawing; }
    const Pen& pen() const { return m_pen; }
    bool has_pen() const { return m_pen.is_in_hand && m_drawing; }
    /// From 0; there always is one while there is a drawing.
    std::size_t keyframe() const;
    /// The points that were clicked so far; null when no line is under way.
    const Stroke* open_line() const { return m_line ? &*m_line : nullptr; }
    /// What a hand at this place would take hold of to move it, or has hold of; `pixel` is how much
    /// one pixel covers there.
    std::optional<StrokeGrip> grip_at(const BeamPlace& place, double pixel) const;
    /// The stroke of the keyframe that a hand points at.
    std::optional<std::size_t> stroke_at(const BeamPlace& place, double pixel) const;
    /// The signal as it is to be seen: while the pen is in the hand its keyframe stands still.
    Spec shown(const Spec& signal) const;

    /// Takes in what became of the document.
    void follow(const Document& document);
    void set_pen(const Pen& pen, Document& document);
    void choose_keyframe(std::size_t keyframe, Document& document);

    /// What the hand does on the picture; `pixel` is how much one pixel covers there.
    void press(const BeamPlace& place, double pixel, Document& document);
    void move(const BeamPlace& place, double pixel, Document& document);
    void release(double pixel, Document& document);
    /// The other button: ends the line that is under way, or deletes the point that it is on.
    void press_other(const BeamPlace& place, double pixel, Document& document);
    /// What is under way is done: with Escape or Enter.
    void end_line(Document& document);

    void add_keyframe(Document& document);  // empty, behind the chosen one, and chosen
    void duplicate_keyframe(Document& document);
    void remove_keyframe(Document& document);
    void move_keyframe(int places, Document& document);
    void clear_keyframe(Document& document);

    /// Another drawing takes the place of the document's signal.
    void replace(const Drawing& drawing, const std::string& step, Document& document);

private:
    void set(const Drawing& drawing, const std::string& step, Document& document,
             bool goes_on = false);
    void insert_keyframe(Keyframe keyframe, const std::string& step, Document& document);
    void click(const BeamPlace& place, double pixel, Document& document);
    void erase(const BeamPlace& place, double pixel, Document& document);
    void add_point(const BeamPlace& place, Document& document);
    void show_line(Document& document);
    void drag(const BeamPlace& place, double pixel, Document& document);

    /// What is being moved, as it was when the hand took hold of it.
    struct Drag {
        StrokeGrip grip;
        BeamPlace from;
        Keyframe before;
        bool has_moved = false;
    };

    Pen m_pen;
    std::size_t m_keyframe = 0;
    std::string m_text;  // that m_drawing was read from
    std::optional<Drawing> m_drawing;
    std::optional<Stroke> m_line;
    bool m_is_line_shown = false;  // it is the last stroke of the document
    std::optional<Drag> m_drag;
};
