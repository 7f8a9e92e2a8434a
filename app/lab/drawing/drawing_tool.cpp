#include "lab/drawing/drawing_tool.h"

#include "formats/svg/svg_file.h"
#include "io/files/atomic_file.h"
#include "lab/document/content_edits.h"
#include "lab/document/users_content.h"
#include "lab/storage/display_name.h"
#include "signals/drawing/stroke_line.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
// Removes points that make no visible difference. Curves from other programs have many.
Drawing lightened(Drawing drawing) {
    constexpr double unseen = 0.0005;  // half screens
    for (Keyframe& keyframe : drawing.keyframes)
        for (Stroke& stroke : keyframe)
            if (!stroke.is_smooth)
                stroke.points = simplified(stroke.points, unseen);
    return drawing;
}

double size_in(const Spec& signal) {
    const Spec any{"drawing", {{"strokes", std::string("[]")}}};
    const auto complete = completed(signal.kind == "drawing" ? signal : any);
    const Spec& sized = complete ? *complete : completed(any).value();
    return std::get<double>(sized.settings.at("size"));
}
}  // namespace

BeamMapping DrawingTool::placing() const {
    return {m_document->look(), m_document->values(), m_size.extent(),
            beam_fit_of(m_document->state().signal)};
}

void DrawingTool::edit(const std::function<void(DrawingBoard&, Document&)>& change) {
    if (!m_document)
        return;
    m_board.follow(*m_document);
    change(m_board, *m_document);
}

void DrawingTool::edit_keyframes(const KeyframeChange& change) {
    edit([&](DrawingBoard& board, Document& document) { board.edit_keyframes(change, document); });
}

void DrawingTool::take_pen(bool is_active) {
    if (!m_document)
        return;
    if (m_document->look().driven_by != Driver::signal)
        return m_messages.say(needs_signal_look, true);
    m_board.follow(*m_document);
    if (is_active && !m_board.drawing()) {
        const Spec& signal = m_document->state().signal;
        if (const std::string file = file_of(signal); signal.kind == "drawing" && !file.empty())
            load(file);
        else
            m_board.replace(Drawing{{{}}}, "New drawing", *m_document);
    }
    Pen pen = m_board.pen();
    pen.is_active = is_active && m_board.drawing();
    m_board.set_pen(pen, *m_document);
}

void DrawingTool::pen_down(const PicturePixel& pixel) {
    if (!m_document)
        return;
    const BeamMapping pixels = placing();
    m_board.press(pixels.position_of(pixel), pixels.pixel_size(), *m_document);
    if (m_board.drawing() && point_count(*m_board.drawing()) + 2 > max_drawing_points)
        m_messages.say(
            fmt::format("The drawing is full. The limit is {} points.", max_drawing_points), true);
}

void DrawingTool::pen_move(const PicturePixel& pixel) {
    if (!m_document)
        return;
    const BeamMapping pixels = placing();
    m_board.move(pixels.position_of(pixel), pixels.pixel_size(), *m_document);
}

void DrawingTool::pen_up() {
    if (m_document)
        m_board.release(placing().pixel_size(), *m_document);
}

void DrawingTool::right_click(const PicturePixel& pixel) {
    if (!m_document)
        return;
    const BeamMapping pixels = placing();
    m_board.press_other(pixels.position_of(pixel), pixels.pixel_size(), *m_document);
}

void DrawingTool::load(const fs::path& file) {
    if (!m_document)
        return;
    if (m_document->look().driven_by != Driver::signal)
        return m_messages.say(needs_signal_look, true);
    const auto loaded = load_svg_drawing(file);
    if (!m_messages.succeeded(loaded))
        return;
    m_opened.add(file);
    const Spec current = m_document->state().signal;
    const Drawing drawing = lightened(to_scale(*loaded, size_in(current)));
    if (point_count(drawing) <= max_drawing_points)
        return m_board.replace(drawing, "Load drawing", *m_document);
    Spec played = current.kind == "drawing" ? current : Spec{"drawing", {}};
    played.settings.erase("");
    played.settings.erase("strokes");
    played.settings["file"] = fs::absolute(file).string();
    set_signal(*m_document, with_round_circles(std::move(played)), false, "Load drawing");
    m_messages.say(fmt::format("\"{}\" plays from its file. Its {} points are too many to edit.",
                               file.filename().string(), point_count(drawing)));
}

void DrawingTool::save(const fs::path& given) {
    if (!m_document)
        return;
    m_board.follow(*m_document);
    if (!m_board.drawing() || !has_strokes(*m_board.drawing()))
        return m_messages.say("The drawing is empty. Draw something first.", true);
    const fs::path file = given.has_extension() ? given : fs::path(given.string() + ".svg");
    if (m_messages.succeeded(write_atomically(file, svg_text(*m_board.drawing()))))
        m_messages.say(saved_text(file.filename().string()));
}
