#include "ui/widgets/problem_list.h"

#include "base/source_excerpt.h"
#include "lab/commands/look_commands.h"
#include "lab/storage/display_name.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

float text_width(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

// The part that the message is about, in the colour of the problem and underlined.
void draw_mark(const SourceExcerpt& excerpt, const ImVec2& start, const ImVec4& color) {
    const std::string_view line = excerpt.line();
    const std::string_view part = line.substr(excerpt.begin, excerpt.end - excerpt.begin);
    const float left = start.x + text_width(line.substr(0, excerpt.begin));
    const float bottom = std::round(start.y + ImGui::GetFontSize()) + 1.0f;
    const float thickness = std::max(std::round(ImGui::GetFontSize() / 10.0f), 1.0f);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText({left, start.y}, ImGui::GetColorU32(color), part.data(),
                 part.data() + part.size());
    list.AddRectFilled({left, bottom - thickness}, {left + text_width(part), bottom},
                       ImGui::GetColorU32(color));
}

void draw_excerpt(const SourceExcerpt& excerpt, const Fonts& fonts, const ImVec4& color) {
    const ScopedFont font(fonts.numbers);
    const ScopedStyle<ImVec2> spacing(
        ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ImGui::GetFontSize() * 0.1f});
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < excerpt.lines.size(); ++i) {
        const bool is_marked = i == excerpt.index;
        const std::string number =
            fmt::format("{:>5}  ", static_cast<std::size_t>(excerpt.first_line) + i);
        ImGui::PushStyleColor(ImGuiCol_Text, theme::dim);
        ImGui::TextUnformatted(number.c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine(0.0f, 0.0f);
        const ImVec2 start = ImGui::GetCursorScreenPos();
        ImGui::PushStyleColor(ImGuiCol_Text, is_marked ? theme::text : theme::label);
        ImGui::TextUnformatted(excerpt.lines[i].c_str());
        ImGui::PopStyleColor();
        if (is_marked && excerpt.end > excerpt.begin)
            draw_mark(excerpt, start, color);
    }
    ImGui::EndGroup();
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
    if (!problem.excerpt.lines.empty())
        draw_excerpt(problem.excerpt, fonts, is_error ? theme::problem : theme::warning);
}

float excerpt_height(const Problem& problem) {
    const auto lines = static_cast<float>(problem.excerpt.lines.size());
    return lines * ImGui::GetFontSize() * 1.15f;
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
