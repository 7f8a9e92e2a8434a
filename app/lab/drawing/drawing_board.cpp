#include "lab/drawing/drawing_board.h"

#include "signals/drawing/stroke_line.h"

#include <utility>

namespace {
constexpr const char* stroke_step = "Stroke";
constexpr const char* move_point_step = "Move point";
constexpr const char* move_stroke_step = "Move stroke";
constexpr double reach_px = 8.0;    // accuracy of pointing
constexpr double tremble_px = 3.0;  // maximum movement of a click

bool is_under_way(const Document& document, std::string_view step) {
    return document.history().is_in_gesture() && document.history().undo_name() == step;
}

std::string move_step(const StrokeGrip& grip) {
    return grip.point ? move_point_step : move_stroke_step;
}
}  // namespace

std::optional<StrokeGrip> DrawingBoard::grip_at(const BeamPosition& position, double pixel) const {
    if (m_drag)
        return m_drag->grip;
    if (!m_drawing.get())
        return std::nullopt;
    return grip_near(m_drawing.strokes(), position, reach_px * pixel);
}

std::optional<std::size_t> DrawingBoard::stroke_at(const BeamPosition& position,
                                                   double pixel) const {
    if (!m_drawing.get())
        return std::nullopt;
    return stroke_near(m_drawing.strokes(), position, reach_px * pixel);
}

Spec DrawingBoard::shown(const Spec& signal) const {
    if (!has_pen())
        return signal;
    Spec still = signal;
    still.settings["play"] = std::string("still");
    still.settings["keyframe"] = static_cast<double>(keyframe() + 1);
    still.settings["spin"] = 0.0;
    return still;
}

void DrawingBoard::follow(const Document& document) {
    if (m_drawing.update(document) && m_drag && !m_drag->has_moved)
        m_drag.reset();  // its stroke or point may no longer exist
    // It was undone, or another edit followed.
    if (!m_drawing.get() || (m_is_line_shown && !is_under_way(document, stroke_step)))
        m_line.reset();
    if (!m_drawing.get() ||
        (m_drag && m_drag->has_moved && !is_under_way(document, move_step(m_drag->grip))))
        m_drag.reset();
    m_is_line_shown = m_is_line_shown && m_line;
}

void DrawingBoard::set_pen(const Pen& pen, Document& document) {
    end_line(document);
    m_pen = pen;
}

void DrawingBoard::edit_keyframes(const KeyframeChange& change, Document& document) {
    end_line(document);
    change(m_drawing, document);
}

void DrawingBoard::set_strokes(Keyframe strokes, const std::string& step, Document& document,
                               bool continues_step) {
    m_drawing.set_strokes(std::move(strokes), step, document, continues_step);
    follow(document);
}

void DrawingBoard::replace(const Drawing& drawing, const std::string& step, Document& document) {
    end_line(document);
    m_drawing.replace(drawing, step, document);
}

void DrawingBoard::press(const BeamPosition& position, double pixel, Document& document) {
    follow(document);
    if (!has_pen())
        return;
    switch (m_pen.tool) {
        case PenTool::freehand:
            end_line(document);
            m_line = Stroke{{position}, m_pen.is_smooth, false};
            return;
        case PenTool::points:
            click(position, pixel, document);
            return;
        case PenTool::edit:
            end_line(document);
            if (const auto grip = grip_at(position, pixel))
                m_drag = Drag{*grip, position, m_drawing.strokes()};
            return;
        case PenTool::erase:
            erase(position, pixel, document);
            return;
    }
}

void DrawingBoard::move(const BeamPosition& position, double pixel, Document& document) {
    follow(document);
    if (m_drag)
        drag(position, pixel, document);
    if (m_pen.tool == PenTool::freehand && m_line &&
        distance(position, m_line->points.back()) >= pixel)
        add_point(position, document);
}

// Ignores small movements during a click.
void DrawingBoard::drag(const BeamPosition& position, double pixel, Document& document) {
    if (!m_drag->has_moved && distance(position, m_drag->from) < tremble_px * pixel)
        return;
    m_drag->has_moved = true;
    set_strokes(with_moved(m_drag->before, m_drag->grip,
                           {position[0] - m_drag->from[0], position[1] - m_drag->from[1]}),
                move_step(m_drag->grip), document, true);
}

void DrawingBoard::release(double pixel, Document& document) {
    follow(document);
    if (m_drag)
        end_line(document);
    if (m_pen.tool != PenTool::freehand || !m_line)
        return;
    // Freehand lines consist of steps of whole pixels.
    m_line->points = simplified(m_line->points, 0.75 * pixel);
    if (m_is_line_shown)
        show_line(document);
    end_line(document);
}

void DrawingBoard::press_other(const BeamPosition& position, double pixel, Document& document) {
    follow(document);
    const bool was_under_way = m_line || m_drag;
    end_line(document);
    if (was_under_way || !has_pen() || m_pen.tool != PenTool::edit)
        return;
    const auto grip = grip_at(position, pixel);
    if (!grip || !grip->point)
        return;
    Keyframe strokes = without_point(m_drawing.strokes(), *grip);
    const bool is_whole = strokes.size() < m_drawing.strokes().size();
    set_strokes(std::move(strokes), is_whole ? "Delete stroke" : "Delete point", document);
}

void DrawingBoard::click(const BeamPosition& position, double pixel, Document& document) {
    if (!m_line) {
        m_line = Stroke{{position}, m_pen.is_smooth, false};
        return;
    }
    const std::vector<BeamPosition>& points = m_line->points;
    if (distance(position, points.back()) <= tremble_px * pixel) {
        end_line(document);
    } else if (points.size() > 2 && distance(position, points.front()) <= reach_px * pixel) {
        m_line->is_closed = true;
        show_line(document);
        end_line(document);
    } else {
        add_point(position, document);
    }
}

void DrawingBoard::erase(const BeamPosition& position, double pixel, Document& document) {
    const auto stroke = stroke_at(position, pixel);
    if (!stroke)
        return;
    Keyframe strokes = m_drawing.strokes();
    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(*stroke));
    set_strokes(std::move(strokes), "Delete stroke", document);
}

// Ignores points beyond the limit of a drawing.
void DrawingBoard::add_point(const BeamPosition& position, Document& document) {
    if (point_count(*m_drawing.get()) + 2 > max_drawing_points)
        return;
    m_line->points.push_back(position);
    show_line(document);
}

void DrawingBoard::show_line(Document& document) {
    Keyframe strokes = m_drawing.strokes();
    if (m_is_line_shown)
        strokes.pop_back();
    strokes.push_back(*m_line);
    set_strokes(std::move(strokes), stroke_step, document, true);
    m_is_line_shown = true;
}

void DrawingBoard::end_line(Document& document) {
    const bool is_line = m_is_line_shown && is_under_way(document, stroke_step);
    const bool is_drag =
        m_drag && m_drag->has_moved && is_under_way(document, move_step(m_drag->grip));
    if (is_line || is_drag)
        document.finish();
    m_line.reset();
    m_drag.reset();
    m_is_line_shown = false;
}
