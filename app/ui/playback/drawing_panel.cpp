#include "ui/playback/drawing_panel.h"

#include "lab/drawing/drawing_tool.h"
#include "ui/frame/action.h"
#include "ui/widgets/form.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>

namespace {

void set_pen(const Pen& pen, Edits& edits) {
    edits.change([pen](DrawingTool& drawing) {
        drawing.edit(
            [pen](DrawingBoard& board, Document& document) { board.set_pen(pen, document); });
    });
}

void draw_pen_button(const Scene& scene, Edits& edits) {
    const bool has_pen = scene.lab.drawing.board().has_pen();
    const ScopedColor back(ImGuiCol_Button, has_pen ? theme::accent_filled : theme::field);
    const char* label = has_pen ? "Done drawing" : "Draw on the picture";
    if (ImGui::Button(label, {form_width(), 0.0f}))
        run(ActionId::draw, scene, edits);
    edits.mark("pen");
    tooltip(has_pen
                ? "Stop drawing (D). Keyframes play, and dragging moves the picture again."
                : "Start drawing (D). The left button draws, the middle button moves the picture.");
}

const char* help_of(PenTool tool, bool is_line_open) {
    switch (tool) {
        case PenTool::freehand:
            return "Hold the left button and draw on the picture.";
        case PenTool::points:
            return is_line_open ? "Press Esc to end the line, or click its first point to close it."
                                : "Click on the picture to add points.";
        case PenTool::edit:
            return "Drag a point or a whole line. Right-click a point to delete it.";
        case PenTool::erase:
            return "Click a stroke to delete it.";
    }
    return "";
}

void draw_tools(const DrawingBoard& board, Edits& edits) {
    constexpr std::array tools{"Freehand", "Points", "Edit", "Erase"};
    Pen pen = board.pen();
    const int tool = choice("pen_tool", tools.data(), static_cast<int>(tools.size()),
                            static_cast<int>(pen.tool), edits);
    pen.tool = static_cast<PenTool>(tool);
    {
        constexpr std::array lines{"Smooth", "Straight"};
        const ScopedDisabled idle(pen.tool == PenTool::edit || pen.tool == PenTool::erase);
        pen.is_smooth = choice("pen_line", lines.data(), static_cast<int>(lines.size()),
                               pen.is_smooth ? 0 : 1, edits) == 0;
    }
    wrapped_dim_text(help_of(pen.tool, board.open_line() != nullptr));
    if (pen != board.pen())
        set_pen(pen, edits);
}

void draw_keyframe_numbers(const DrawingBoard& board, Edits& edits) {
    constexpr std::size_t a_row = 7;
    const std::size_t count = board.drawing()->keyframes.size();
    const std::size_t current = board.keyframe();
    for (std::size_t first = 0; first < count; first += a_row) {
        std::vector<std::string> names;
        std::vector<const char*> labels;
        for (std::size_t i = first; i < std::min(first + a_row, count); ++i)
            names.push_back(std::to_string(i + 1));
        for (const std::string& name : names)
            labels.push_back(name.c_str());
        const int before = static_cast<int>(current) - static_cast<int>(first);
        const int chosen =
            choice("keyframe", labels.data(), static_cast<int>(labels.size()), before, edits);
        if (chosen == before)
            continue;
        const std::size_t keyframe = first + static_cast<std::size_t>(chosen);
        edits.change([keyframe](DrawingTool& tool) {
            tool.edit_keyframes([keyframe](EditedDrawing& drawing, Document&) {
                drawing.choose_keyframe(keyframe);
            });
        });
    }
}

/// A button that changes the selected keyframe.
struct KeyframeButton {
    const char* label;
    const char* id;
    const char* help;
    bool is_enabled;
    KeyframeChange act;
};

void draw_buttons(const std::vector<KeyframeButton>& buttons, Edits& edits) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto count = static_cast<float>(buttons.size());
    const float width = (form_width() - (count - 1.0f) * gap) / count;
    for (const KeyframeButton& button : buttons) {
        if (&button != &buttons.front())
            ImGui::SameLine(0.0f, gap);
        {
            const ScopedDisabled idle(!button.is_enabled);
            if (ImGui::Button(button.label, {width, 0.0f}))
                edits.change(
                    [act = button.act](DrawingTool& drawing) { drawing.edit_keyframes(act); });
        }
        edits.mark(button.id);
        tooltip(button.help);
    }
}

void draw_keyframes(const DrawingBoard& board, Edits& edits) {
    const std::vector<Keyframe>& keyframes = board.drawing()->keyframes;
    const std::size_t current = board.keyframe();
    const bool has_room = keyframes.size() < max_keyframes;
    ImGui::AlignTextToFramePadding();
    dim_text("Keyframe");
    ImGui::SameLine();
    ImGui::BeginGroup();
    draw_keyframe_numbers(board, edits);
    ImGui::EndGroup();
    draw_buttons(
        {{"New", "keyframe_new", "Adds an empty keyframe after this one.", has_room,
          &EditedDrawing::add_keyframe},
         {"Copy", "keyframe_copy",
          "Adds a copy of this keyframe after it. Strokes morph into one another in their order.",
          has_room, &EditedDrawing::duplicate_keyframe},
         {"Remove", "keyframe_remove", "Removes this keyframe. The last one can't be removed.",
          keyframes.size() > 1, &EditedDrawing::remove_keyframe}},
        edits);
    const auto move = [](int steps) {
        return [steps](EditedDrawing& drawing, Document& document) {
            drawing.move_keyframe(steps, document);
        };
    };
    draw_buttons({{"Earlier", "keyframe_earlier", "Moves this keyframe one place earlier.",
                   current > 0, move(-1)},
                  {"Later", "keyframe_later", "Moves this keyframe one place later.",
                   current + 1 < keyframes.size(), move(1)},
                  {"Clear", "keyframe_clear", "Deletes all strokes of this keyframe.",
                   !keyframes[current].empty(), &EditedDrawing::clear_keyframe}},
                 edits);
}

void draw_files(const DrawingBoard& board, Edits& edits) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = 0.5f * (form_width() - gap);
    if (ImGui::Button("Load SVG…", {width, 0.0f}))
        edits.show({.kind = Dialog::Kind::load_drawing});
    edits.mark("load_drawing");
    tooltip(
        "Replaces this drawing with the lines of an SVG file. An SVG saved here keeps its "
        "keyframes.");
    ImGui::SameLine(0.0f, gap);
    {
        const ScopedDisabled idle(!board.drawing() || !has_strokes(*board.drawing()));
        if (ImGui::Button("Save SVG…", {width, 0.0f}))
            edits.show({.kind = Dialog::Kind::save_drawing});
    }
    edits.mark("save_drawing");
    tooltip(
        "Saves an SVG file for other programs and the command line. Presets already contain the "
        "drawing.");
}
}  // namespace

void draw_drawing_panel(const Scene& scene, Edits& edits) {
    const DrawingBoard& board = scene.lab.drawing.board();
    draw_pen_button(scene, edits);
    if (board.has_pen()) {
        draw_tools(board, edits);
        draw_keyframes(board, edits);
    }
    draw_files(board, edits);
    ImGui::Spacing();
}
