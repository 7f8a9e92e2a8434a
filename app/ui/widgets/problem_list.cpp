#include "ui/widgets/problem_list.h"

#include "lab/commands/look_commands.h"
#include "lab/storage/display_name.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
std::string location_text(const Diagnostic& diagnostic) {
    if (diagnostic.file.empty())
        return {};
    const std::string name = display_name(diagnostic.file);
    return diagnostic.line > 0 ? fmt::format("{}:{}", name, diagnostic.line) : name;
}

void draw_location(const Diagnostic& diagnostic, const ImVec4& color, Edits& edits) {
    const std::string text = location_text(diagnostic);
    if (text.empty())
        return;
    const ScopedColor scoped(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    edits.mark("problem:" + text.substr(text.rfind('/') + 1));
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 high = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddLine({low.x, high.y}, high, ImGui::GetColorU32(color));
    }
    if (ImGui::IsItemClicked()) {
        const Location location{diagnostic.file, diagnostic.line};
        edits.change([location](LookCommands& looks) { looks.open_in_editor(location); });
    }
    editor_tooltip(diagnostic.file);
    ImGui::SameLine();
}

void draw_source_line(const std::string& line, const Fonts& fonts) {
    const ScopedFont font(fonts.numbers);
    const std::string text = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    ImGui::Indent();
    fitted_text(text, ImGui::GetContentRegionAvail().x, theme::label);
    ImGui::Unindent();
}
}  // namespace

void draw_problem(const Problem& problem, const Fonts& fonts, Edits& edits) {
    const Diagnostic& diagnostic = problem.diagnostic;
    const ScopedId id(to_string(diagnostic));
    const bool is_error = diagnostic.severity == Severity::error;
    draw_location(diagnostic, is_error ? theme::problem : theme::warning, edits);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(diagnostic.message.c_str());
    ImGui::PopTextWrapPos();
    if (!problem.source_line.empty())
        draw_source_line(problem.source_line, fonts);
}

void draw_file_problems(const Scene& scene, Edits& edits) {
    for (const Diagnostic& problem : scene.lab.media.problems()) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextWrapped("%s: %s", problem.file.filename().string().c_str(),
                           problem.message.c_str());
        edits.mark("media_problem");
    }
}

void draw_problems_panel(const Scene& scene, Edits& edits) {
    if (scene.lab.messages.problems().empty())
        dim_text("No problems.");
    for (const Problem& problem : scene.lab.messages.problems()) {
        draw_problem(problem, scene.fonts, edits);
        ImGui::Spacing();
    }
}
