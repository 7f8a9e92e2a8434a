#pragma once

#include "lab/document/document.h"
#include "signals/drawing/drawing.h"

#include <optional>
#include <string>

/// The hand drawing of the document's signal, and its current keyframe.
class EditedDrawing {
public:
    /// Null: the signal is not a hand drawing.
    const Drawing* get() const { return m_drawing ? &*m_drawing : nullptr; }
    /// From 0; a drawing has at least one keyframe.
    std::size_t keyframe() const;
    /// The strokes of the current keyframe of a drawing.
    const Keyframe& strokes() const { return m_drawing->keyframes[keyframe()]; }

    /// Reads the document; true if the drawing has changed.
    bool update(const Document& document);
    /// Replaces the document's signal by this drawing.
    void replace(const Drawing& drawing, const std::string& step, Document& document);
    /// Replaces the strokes of the current keyframe; `continues_step` continues the undo step.
    void set_strokes(Keyframe strokes, const std::string& step, Document& document,
                     bool continues_step = false);

    void choose_keyframe(std::size_t keyframe) { m_keyframe = keyframe; }
    void add_keyframe(Document& document);  // empty, after the current one; becomes current
    void duplicate_keyframe(Document& document);
    void remove_keyframe(Document& document);
    void move_keyframe(int steps, Document& document);
    void clear_keyframe(Document& document);

private:
    void set(const Drawing& drawing, const std::string& step, Document& document,
             bool continues_step = false);
    void insert_keyframe(Keyframe strokes, const std::string& step, Document& document);

    std::string m_text;  // source text of m_drawing
    std::optional<Drawing> m_drawing;
    std::size_t m_keyframe = 0;
};
