#include "lab/drawing/edited_drawing.h"

#include "lab/document/content_edits.h"
#include "lab/document/users_content.h"

#include <algorithm>
#include <utility>

namespace {
std::string strokes_of(const Spec& signal) {
    const auto found = signal.settings.find("strokes");
    if (signal.kind != "drawing" || found == signal.settings.end())
        return {};
    const std::string* text = std::get_if<std::string>(&found->second);
    return text ? *text : std::string();
}
}  // namespace

std::size_t EditedDrawing::keyframe() const {
    return m_drawing ? std::min(m_keyframe, m_drawing->keyframes.size() - 1) : 0;
}

bool EditedDrawing::update(const Document& document) {
    const bool is_driven = document.look().driven_by == Driver::signal;
    std::string text = is_driven ? strokes_of(document.state().signal) : std::string();
    if (text == m_text)
        return false;
    m_text = std::move(text);
    m_drawing.reset();
    if (auto drawing = m_text.empty() ? Result<Drawing>(Drawing{}) : parse_drawing(m_text);
        drawing && !drawing->keyframes.empty())
        m_drawing = std::move(*drawing);
    return true;
}

void EditedDrawing::set(const Drawing& drawing, const std::string& step, Document& document,
                        bool continues_step) {
    Spec signal = document.state().signal;
    signal.settings["strokes"] = to_text(drawing);
    set_signal(document, std::move(signal), continues_step, step);
    update(document);
}

void EditedDrawing::replace(const Drawing& drawing, const std::string& step, Document& document) {
    Spec signal = document.state().signal;
    const bool is_new = signal.kind != "drawing";
    if (is_new)
        signal = Spec{"drawing", {}};
    signal.settings.erase("");
    signal.settings.erase("file");
    signal.settings["strokes"] = to_text(drawing);
    if (is_new)
        signal = with_round_circles(std::move(signal));
    set_signal(document, std::move(signal), false, step);
    m_keyframe = 0;
    update(document);
}

void EditedDrawing::set_strokes(Keyframe strokes, const std::string& step, Document& document,
                                bool continues_step) {
    Drawing drawing = *m_drawing;
    drawing.keyframes[keyframe()] = std::move(strokes);
    set(drawing, step, document, continues_step);
}

void EditedDrawing::insert_keyframe(Keyframe strokes, const std::string& step, Document& document) {
    if (!m_drawing || m_drawing->keyframes.size() >= max_keyframes)
        return;
    Drawing drawing = *m_drawing;
    const std::size_t index = keyframe() + 1;
    drawing.keyframes.insert(drawing.keyframes.begin() + static_cast<std::ptrdiff_t>(index),
                             std::move(strokes));
    if (point_count(drawing) > max_drawing_points)
        return;
    set(drawing, step, document);
    m_keyframe = index;
}

void EditedDrawing::add_keyframe(Document& document) {
    insert_keyframe({}, "Add keyframe", document);
}

void EditedDrawing::duplicate_keyframe(Document& document) {
    if (m_drawing)
        insert_keyframe(strokes(), "Duplicate keyframe", document);
}

void EditedDrawing::remove_keyframe(Document& document) {
    if (!m_drawing || m_drawing->keyframes.size() < 2)
        return;
    Drawing drawing = *m_drawing;
    const std::size_t index = keyframe();
    drawing.keyframes.erase(drawing.keyframes.begin() + static_cast<std::ptrdiff_t>(index));
    set(drawing, "Remove keyframe", document);
    m_keyframe = index > 0 ? index - 1 : 0;
}

void EditedDrawing::move_keyframe(int steps, Document& document) {
    if (!m_drawing)
        return;
    Drawing drawing = *m_drawing;
    const std::size_t index = keyframe();
    const auto last = static_cast<std::ptrdiff_t>(drawing.keyframes.size()) - 1;
    const auto next = static_cast<std::size_t>(
        std::clamp(static_cast<std::ptrdiff_t>(index) + steps, std::ptrdiff_t{0}, last));
    std::swap(drawing.keyframes[index], drawing.keyframes[next]);
    set(drawing, "Move keyframe", document);
    m_keyframe = next;
}

void EditedDrawing::clear_keyframe(Document& document) {
    if (m_drawing)
        set_strokes({}, "Clear keyframe", document);
}
