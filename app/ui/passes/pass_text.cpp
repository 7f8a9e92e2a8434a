#include "ui/passes/pass_text.h"

#include "base/text.h"
#include "lab/commands/look_commands.h"
#include "lab/views/views.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
// Lines added by Afterglow have no file.
std::string origin_text(const Location& origin) {
    return origin.file.empty() ? "Afterglow"
                               : fmt::format("{}:{}", origin.file.filename().string(), origin.line);
}

float origin_width(const Stage& stage) {
    float widest = 0.0f;
    for (std::size_t i = 0; const LineMap::Stretch& stretch : stage.lines.stretches()) {
        // The last line of a stretch has the most digits.
        const Location last{stretch.first.file,
                            stretch.first.line + static_cast<int>(stretch.end - i) - 1};
        widest = std::max(widest, ImGui::CalcTextSize(origin_text(last).c_str()).x);
        i = stretch.end;
    }
    return std::max(widest, ImGui::CalcTextSize("Afterglow").x);
}

void draw_line(int number, std::string_view text, const Location& origin, float width,
               Edits& edits) {
    const ScopedId id(number);
    const float left = ImGui::GetCursorPosX();
    const float gap = ImGui::GetFontSize();
    const bool is_chosen = ImGui::Selectable("##line");
    if (!origin.file.empty()) {
        edits.mark("text_line:" + origin_text(origin));
        editor_tooltip(origin.file);
        if (is_chosen)
            edits.change([origin](LookCommands& looks) { looks.open_in_editor(origin); });
    }
    const std::string number_text = fmt::format("{:>4}", number);
    ImGui::SameLine(left);
    dim_text(number_text);
    ImGui::SameLine(left + ImGui::CalcTextSize(number_text.c_str()).x + gap);
    dim_text(origin_text(origin));
    ImGui::SameLine(left + ImGui::CalcTextSize(number_text.c_str()).x + width + 2.0f * gap);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void draw_stage(const char* name, const Stage& stage, Edits& edits) {
    if (!section(name, true))
        return;
    const ScopedId id(name);
    const std::vector<std::string_view> lines = split_lines(stage.text);
    const float width = origin_width(stage);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_line(i + 1, lines[static_cast<std::size_t>(i)],
                      stage.lines.empty() ? Location{} : origin_of(stage.lines, i + 1), width,
                      edits);
    clipper.End();
}
}  // namespace

void draw_pass_text(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer)
        return;
    const Executor& executor = scene.lab.renderer->executor();
    const auto index =
        static_cast<std::size_t>(inspected_pass(executor.look(), scene.window.views.inspected));
    const Pass& pass = executor.look().passes[index];
    const Stage own{{}, executor.programs().generic().passes[index].vertex, {}};
    const ScopedFont font(scene.fonts.numbers);
    draw_stage("Fragment shader", pass.fragment, edits);
    draw_stage("Vertex shader", pass.vertex.text->empty() ? own : pass.vertex, edits);
}
