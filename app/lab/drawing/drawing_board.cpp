#include "lab/drawing/drawing_board.h"

#include "lab/document/users_content.h"
#include "signals/drawing/stroke_line.h"

#include <algorithm>

namespace {
constexpr const char* stroke_step = "Stroke";
constexpr const char* move_point_step = "Move point";
constexpr const char* move_stroke_step = "Move stroke";
constexpr double reach_px = 8.0;    // accuracy of pointing
constexpr double tremble_px = 3.0;  // maximum movement of a click

std::string strokes_of(const Spec& signal) {
    const auto found = signal.settings.find("strokes");
    if (signal.kind != "drawing" || found == signal.settings.end())
        return {};
    const std::string* text = std::get_if<std::string>(&found->second);
    return text ? *text : std::string();
}

bool is_under_way(const Document& document, std::string_view step) {
    return document.history().is_in_gesture() && document.history().undo_name() == step;
}

std::string move_step(const StrokeGrip& grip) {
    return grip.point ? move_point_step : move_stroke_step;
}
}  // namespace

std::size_t DrawingBoard::keyframe() const {
    return m_drawing ? std::min(m_keyframe, m_drawing->keyframes.size() - 1) : 0;
}

std::optional<StrokeGrip> DrawingBoard::grip_at(const BeamPlace& place, double pixel) const {
    if (m_drag)
        return m_drag->grip;
    if (!m_drawing)
        return std::nullopt;
    return grip_near(m_drawing->keyframes[keyframe()], place, reach_px * pixel);
}

std::optional<std::size_t> DrawingBoard::stroke_at(const BeamPlace& place, double pixel) const {
    if (!m_drawing)
        return std::nullopt;
    return stroke_near(m_drawing->keyframes[keyframe()], place, reach_px * pixel);
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
    const bool is_driven = document.look().driven_by == Driver::signal;
    const std::string text = is_driven ? strokes_of(document.state().signal) : std::string();
    if (text != m_text) {
        if (m_drag && !m_drag->has_moved)
            m_drag.reset();  // its stroke or point may no longer exist
        m_text = text;
        m_drawing.reset();
        if (auto drawing = text.empty() ? Result<Drawing>(Drawing{}) : parse_drawing(text);
            drawing && !drawing->keyframes.empty())
            m_drawing = std::move(*drawing);
    }
    // It was undone, or another edit followed.
    if (!m_drawing || (m_is_line_shown && !is_under_way(document, stroke_step)))
        m_line.reset();
    if (!m_drawing ||
        (m_drag && m_drag->has_moved && !is_under_way(document, move_step(m_drag->grip))))
        m_drag.reset();
    m_is_line_shown = m_is_line_shown && m_line;
}

void DrawingBoard::set_pen(const Pen& pen, Document& document) {
    end_line(document);
    m_pen = pen;
}

void DrawingBoard::choose_keyframe(std::size_t keyframe, Document& document) {
    end_line(document);
    m_keyframe = keyframe;
}

void DrawingBoard::set(const Drawing& drawing, const std::string& step, Document& document,
                       bool goes_on) {
    Spec signal = document.state().signal;
    signal.settings["strokes"] = to_text(drawing);
    document.set_signal(std::move(signal), goes_on, step);
    follow(document);
}

void DrawingBoard::replace(const Drawing& drawing, const std::string& step, Document& document) {
    end_line(document);
    Spec signal = document.state().signal;
    const bool is_new = signal.kind != "drawing";
    if (is_new)
        signal = Spec{"drawing", {}};
    signal.settings.erase("");
    signal.settings.erase("file");
    signal.settings["strokes"] = to_text(drawing);
    if (is_new)
        signal = with_round_circles(std::move(signal));
    document.set_signal(std::move(signal), false, step);
    m_keyframe = 0;
    follow(document);
}

void DrawingBoard::press(const BeamPlace& place, double pixel, Document& document) {
    follow(document);
    if (!has_pen())
        return;
    switch (m_pen.tool) {
        case PenTool::freehand:
            end_line(document);
            m_line = Stroke{{place}, m_pen.is_smooth, false};
            return;
        case PenTool::points:
            click(place, pixel, document);
            return;
        case PenTool::edit:
            end_line(document);
            if (const auto grip = grip_at(place, pixel))
                m_drag = Drag{*grip, place, m_drawing->keyframes[keyframe()]};
            return;
        case PenTool::erase:
            erase(place, pixel, document);
            return;
    }
}

void DrawingBoard::move(const BeamPlace& place, double pixel, Document& document) {
    follow(document);
    if (m_drag)
        drag(place, pixel, document);
    if (m_pen.tool == PenTool::freehand && m_line &&
        distance(place, m_line->points.back()) >= pixel)
        add_point(place, document);
}

// Ignores small movements during a click.
void DrawingBoard::drag(const BeamPlace& place, double pixel, Document& document) {
    if (!m_drag->has_moved && distance(place, m_drag->from) < tremble_px * pixel)
        return;
    m_drag->has_moved = true;
    Drawing drawing = *m_drawing;
    drawing.keyframes[keyframe()] = with_moved(
        m_drag->before, m_drag->grip, {place[0] - m_drag->from[0], place[1] - m_drag->from[1]});
    set(drawing, move_step(m_drag->grip), document, true);
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

void DrawingBoard::press_other(const BeamPlace& place, double pixel, Document& document) {
    follow(document);
    const bool was_under_way = m_line || m_drag;
    end_line(document);
    if (was_under_way || !has_pen() || m_pen.tool != PenTool::edit)
        return;
    const auto grip = grip_at(place, pixel);
    if (!grip || !grip->point)
        return;
    Drawing drawing = *m_drawing;
    Keyframe& strokes = drawing.keyframes[keyframe()];
    const std::size_t count = strokes.size();
    strokes = without_point(std::move(strokes), *grip);
    set(drawing, strokes.size() < count ? "Delete stroke" : "Delete point", document);
}

void DrawingBoard::click(const BeamPlace& place, double pixel, Document& document) {
    if (!m_line) {
        m_line = Stroke{{place}, m_pen.is_smooth, false};
        return;
    }
    const std::vector<BeamPlace>& points = m_line->points;
    if (distance(place, points.back()) <= tremble_px * pixel) {
        end_line(document);
    } else if (points.size() > 2 && distance(place, points.front()) <= reach_px * pixel) {
        m_line->is_closed = true;
        show_line(document);
        end_line(document);
    } else {
        add_point(place, document);
    }
}

void DrawingBoard::erase(const BeamPlace& place, double pixel, Document& document) {
    const auto stroke = stroke_at(place, pixel);
    if (!stroke)
        return;
    Drawing drawing = *m_drawing;
    Keyframe& strokes = drawing.keyframes[keyframe()];
    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(*stroke));
    set(drawing, "Delete stroke", document);
}

// Ignores points beyond the limit of a drawing.
void DrawingBoard::add_point(const BeamPlace& place, Document& document) {
    if (point_count(*m_drawing) + 2 > most_drawing_points)
        return;
    m_line->points.push_back(place);
    show_line(document);
}

void DrawingBoard::show_line(Document& document) {
    Drawing drawing = *m_drawing;
    Keyframe& strokes = drawing.keyframes[keyframe()];
    if (m_is_line_shown)
        strokes.pop_back();
    strokes.push_back(*m_line);
    set(drawing, stroke_step, document, true);
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

void DrawingBoard::insert_keyframe(Keyframe keyframe, const std::string& step, Document& document) {
    end_line(document);
    if (!m_drawing || m_drawing->keyframes.size() >= most_keyframes)
        return;
    Drawing drawing = *m_drawing;
    const std::size_t place = this->keyframe() + 1;
    drawing.keyframes.insert(drawing.keyframes.begin() + static_cast<std::ptrdiff_t>(place),
                             std::move(keyframe));
    if (point_count(drawing) > most_drawing_points)
        return;
    set(drawing, step, document);
    m_keyframe = place;
}

void DrawingBoard::add_keyframe(Document& document) {
    insert_keyframe({}, "Add keyframe", document);
}

void DrawingBoard::duplicate_keyframe(Document& document) {
    if (m_drawing)
        insert_keyframe(m_drawing->keyframes[keyframe()], "Duplicate keyframe", document);
}

void DrawingBoard::remove_keyframe(Document& document) {
    end_line(document);
    if (!m_drawing || m_drawing->keyframes.size() < 2)
        return;
    Drawing drawing = *m_drawing;
    const std::size_t place = keyframe();
    drawing.keyframes.erase(drawing.keyframes.begin() + static_cast<std::ptrdiff_t>(place));
    set(drawing, "Remove keyframe", document);
    m_keyframe = place > 0 ? place - 1 : 0;
}

void DrawingBoard::move_keyframe(int places, Document& document) {
    end_line(document);
    if (!m_drawing)
        return;
    Drawing drawing = *m_drawing;
    const std::size_t place = keyframe();
    const auto last = static_cast<std::ptrdiff_t>(drawing.keyframes.size()) - 1;
    const auto next = static_cast<std::size_t>(
        std::clamp(static_cast<std::ptrdiff_t>(place) + places, std::ptrdiff_t{0}, last));
    std::swap(drawing.keyframes[place], drawing.keyframes[next]);
    set(drawing, "Move keyframe", document);
    m_keyframe = next;
}

void DrawingBoard::clear_keyframe(Document& document) {
    end_line(document);
    if (!m_drawing)
        return;
    Drawing drawing = *m_drawing;
    drawing.keyframes[keyframe()].clear();
    set(drawing, "Clear keyframe", document);
}
