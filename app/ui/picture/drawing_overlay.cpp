#include "ui/picture/drawing_overlay.h"

#include "lab/drawing/drawing_tool.h"
#include "signals/drawing/stroke_line.h"
#include "ui/widgets/theme.h"

namespace {
/// Draws lines given by beam positions on the screen.
class Overlay {
public:
    Overlay(const Scene& scene, const std::function<ImVec2(const PicturePixel&)>& screen)
        : m_placing(scene.lab.drawing.placing()), m_screen(screen), m_scale(scene.scale) {}

    ImVec2 at(const BeamPosition& position) const { return m_screen(m_placing.pixel_of(position)); }

    void draw(const std::vector<BeamPosition>& line, const theme::Color& color, float width) const {
        std::vector<ImVec2> points;
        for (const BeamPosition& position : line)
            points.push_back(at(position));
        ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                                theme::packed(color), 0, width * m_scale);
    }

    void draw_dot(const BeamPosition& position, const theme::Color& color,
                  float radius = 2.5f) const {
        ImGui::GetWindowDrawList()->AddCircleFilled(at(position), radius * m_scale,
                                                    theme::packed(color));
    }

    const BeamMapping& placing() const { return m_placing; }

private:
    BeamMapping m_placing;
    const std::function<ImVec2(const PicturePixel&)>& m_screen;
    float m_scale;
};

void draw_open_line(const Stroke& line, const CanvasInput& input, const Overlay& overlay) {
    for (const BeamPosition& point : line.points)
        overlay.draw_dot(point, theme::accent);
    if (input.hovered)
        overlay.draw({line.points.back(), overlay.placing().position_of(*input.hovered)},
                     theme::accent, 1.0f);
}

// All grips, and the one that is hovered or dragged.
void draw_grips(const DrawingBoard& board, const CanvasInput& input, const Overlay& overlay) {
    const Keyframe& strokes = board.drawing()->keyframes[board.keyframe()];
    const auto grip = input.hovered ? board.grip_at(overlay.placing().position_of(*input.hovered),
                                                    overlay.placing().pixel_size())
                                    : std::nullopt;
    if (grip && !grip->point)
        overlay.draw(line_of(strokes[grip->stroke]), theme::accent, 2.0f);
    for (const Stroke& stroke : strokes)
        for (const BeamPosition& point : stroke.points)
            overlay.draw_dot(point, theme::label);
    if (grip && grip->point)
        overlay.draw_dot(strokes[grip->stroke].points[*grip->point], theme::accent, 5.0f);
}
}  // namespace

void draw_drawing_overlay(const Scene& scene, const CanvasInput& input,
                          const std::function<ImVec2(const PicturePixel&)>& screen) {
    constexpr theme::Color before{0.55f, 0.55f, 0.60f, 0.45f};
    const DrawingBoard& board = scene.lab.drawing.board();
    if (!board.has_pen())
        return;
    const Overlay overlay(scene, screen);
    const auto& keyframes = board.drawing()->keyframes;
    if (board.keyframe() > 0)
        for (const Stroke& stroke : keyframes[board.keyframe() - 1])
            overlay.draw(line_of(stroke), before, 1.0f);
    if (const Stroke* line = board.open_line(); line && board.pen().tool == PenTool::points)
        draw_open_line(*line, input, overlay);
    if (board.pen().tool == PenTool::edit)
        draw_grips(board, input, overlay);
    if (board.pen().tool != PenTool::erase || !input.hovered)
        return;
    if (const auto stroke = board.stroke_at(overlay.placing().position_of(*input.hovered),
                                            overlay.placing().pixel_size()))
        overlay.draw(line_of(keyframes[board.keyframe()][*stroke]), theme::problem, 2.0f);
}
