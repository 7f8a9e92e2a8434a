#pragma once

#include "lab/document/document.h"
#include "lab/drawing/edited_drawing.h"
#include "lab/drawing/stroke_grip.h"

#include <functional>
#include <optional>
#include <string>

/// The function of the left button on the picture while the pen is active.
enum class PenTool { freehand, points, edit, erase };

struct Pen {
    bool is_active = false;
    PenTool tool = PenTool::freehand;
    bool is_smooth = true;  // of new strokes

    bool operator==(const Pen&) const = default;
};

using KeyframeChange = std::function<void(EditedDrawing&, Document&)>;

/// The state of drawing by hand: pen, open line and drag. The drawing itself is a setting of the
/// document's signal.
class DrawingBoard {
public:
    /// As in EditedDrawing.
    const Drawing* drawing() const { return m_drawing.get(); }
    std::size_t keyframe() const { return m_drawing.keyframe(); }
    const Pen& pen() const { return m_pen; }
    bool has_pen() const { return m_pen.is_active && m_drawing.get(); }
    /// The points clicked so far; null: no open line.
    const Stroke* open_line() const { return m_line ? &*m_line : nullptr; }
    /// The point or stroke at this position that would be moved, or is being moved. `pixel`: the
    /// size of a pixel in beam coordinates.
    std::optional<StrokeGrip> grip_at(const BeamPosition& position, double pixel) const;
    /// The stroke of the keyframe at this position.
    std::optional<std::size_t> stroke_at(const BeamPosition& position, double pixel) const;
    /// The signal for display. While the pen is active, it shows its keyframe without animation.
    Spec shown(const Spec& signal) const;

    /// Updates the board after changes of the document.
    void follow(const Document& document);
    void set_pen(const Pen& pen, Document& document);
    /// Ends the open line or drag, then changes the keyframes.
    void edit_keyframes(const KeyframeChange& change, Document& document);

    /// Input on the picture; `pixel`: the size of a pixel in beam coordinates.
    void press(const BeamPosition& position, double pixel, Document& document);
    void move(const BeamPosition& position, double pixel, Document& document);
    void release(double pixel, Document& document);
    /// The right button ends the open line, or deletes the point under it.
    void press_other(const BeamPosition& position, double pixel, Document& document);
    /// Ends the open line or drag.
    void end_line(Document& document);

    /// Replaces the document's signal by this drawing.
    void replace(const Drawing& drawing, const std::string& step, Document& document);

private:
    void set_strokes(Keyframe strokes, const std::string& step, Document& document,
                     bool continues_step = false);
    void click(const BeamPosition& position, double pixel, Document& document);
    void erase(const BeamPosition& position, double pixel, Document& document);
    void add_point(const BeamPosition& position, Document& document);
    void show_line(Document& document);
    void drag(const BeamPosition& position, double pixel, Document& document);

    /// A point or stroke being dragged, with the keyframe before the drag.
    struct Drag {
        StrokeGrip grip;
        BeamPosition from;
        Keyframe before;
        bool has_moved = false;
    };

    Pen m_pen;
    EditedDrawing m_drawing;
    std::optional<Stroke> m_line;
    bool m_is_line_shown = false;  // it is the last stroke of the document
    std::optional<Drag> m_drag;
};
