#pragma once

#include "lab/drawing/beam_mapping.h"
#include "lab/drawing/drawing_board.h"
#include "lab/library/opened_files.h"
#include "lab/media/render_size.h"
#include "lab/messages/messages.h"

#include <functional>

/// Draws by hand on the picture. The drawing is the signal of the open look.
class DrawingTool {
public:
    DrawingTool(OpenDocument& document, const RenderSize& size, Messages& messages,
                OpenedFiles& opened)
        : m_document(document), m_size(size), m_messages(messages), m_opened(opened) {}

    /// Pen, keyframe and open line.
    const DrawingBoard& board() const { return m_board; }
    /// Converts between pixels of the picture and positions of the signal. A look must be open.
    BeamMapping placing() const;

    /// Activates or deactivates the pen. A signal other than a hand drawing is replaced by the
    /// drawing in its file, otherwise by an empty drawing.
    void take_pen(bool is_active);
    void pen_down(const PicturePixel& pixel);
    void pen_move(const PicturePixel& pixel);
    void pen_up();
    /// The right button ends a line or deletes a point.
    void right_click(const PicturePixel& pixel);
    void edit(const std::function<void(DrawingBoard&, Document&)>& change);
    void edit_keyframes(const KeyframeChange& change);

    /// Loads an SVG as the drawing. If it has too many points to edit, it plays from its file.
    void load(const std::filesystem::path& file);
    void save(const std::filesystem::path& file);  // as SVG

    /// Reloads the drawing if the document's signal has changed.
    void follow() { m_board.follow(*m_document); }

private:
    OpenDocument& m_document;
    const RenderSize& m_size;
    Messages& m_messages;
    OpenedFiles& m_opened;
    DrawingBoard m_board;
};
