#pragma once

#include "lab/document/document.h"
#include "lab/drawing/stroke_grip.h"

#include <optional>

/// The function of the left button on the picture while the pen is active.
enum class PenTool { freehand, points, edit, erase };

struct Pen {
    bool is_in_hand = false;
    PenTool tool = PenTool::freehand;
    bool is_smooth = true;  // of new strokes

    bool operator==(const Pen&) const = default;
};

/// The state of drawing by hand: pen, keyframe and open line. The drawing itself is a setting of
/// the document's signal.
class DrawingBoard {
public:
    /// The drawing of the document's signal; nullopt: not a hand drawing.
    const std::optional<Drawing>& drawing() const { return m_drawing; }
    const Pen& pen() const { return m_pen; }
    bool has_pen() const { return m_pen.is_in_hand && m_drawing; }
    /// From 0; a drawing has at least one keyframe.
    std::size_t keyframe() const;
    /// The points clicked so far; null: no open line.
    const Stroke* open_line() const { return m_line ? &*m_line : nullptr; }
    /// The point or stroke at this position that would be moved, or is being moved. `pixel`: the
    /// size of a pixel in beam coordinates.
    std::optional<StrokeGrip> grip_at(const BeamPlace& place, double pixel) const;
    /// The stroke of the keyframe at this position.
    std::optional<std::size_t> stroke_at(const BeamPlace& place, double pixel) const;
    /// The signal for display. While the pen is active, it shows its keyframe without animation.
    Spec shown(const Spec& signal) const;

    /// Updates the board after changes of the document.
    void follow(const Document& document);
    void set_pen(const Pen& pen, Document& document);
    void choose_keyframe(std::size_t keyframe, Document& document);

    /// Input on the picture; `pixel`: the size of a pixel in beam coordinates.
    void press(const BeamPlace& place, double pixel, Document& document);
    void move(const BeamPlace& place, double pixel, Document& document);
    void release(double pixel, Document& document);
    /// The right button ends the open line, or deletes the point under it.
    void press_other(const BeamPlace& place, double pixel, Document& document);
    /// Ends the open line or drag.
    void end_line(Document& document);

    void add_keyframe(Document& document);  // empty, after the current one; becomes current
    void duplicate_keyframe(Document& document);
    void remove_keyframe(Document& document);
    void move_keyframe(int places, Document& document);
    void clear_keyframe(Document& document);

    /// Replaces the document's signal by this drawing.
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

    /// A point or stroke being dragged, with the keyframe before the drag.
    struct Drag {
        StrokeGrip grip;
        BeamPlace from;
        Keyframe before;
        bool has_moved = false;
    };

    Pen m_pen;
    std::size_t m_keyframe = 0;
    std::string m_text;  // source text of m_drawing
    std::optional<Drawing> m_drawing;
    std::optional<Stroke> m_line;
    bool m_is_line_shown = false;  // it is the last stroke of the document
    std::optional<Drag> m_drag;
};
