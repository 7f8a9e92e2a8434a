#include "ui/passes/pass_text.h"

#include "base/text.h"
#include "lab/commands/look_commands.h"
#include "lab/inspect/source_colors.h"
#include "lab/views/views.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/search_box.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>
#include <span>

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

const theme::Color& color_of(CodeSpan::Kind kind) {
    static constexpr std::array colors{theme::text,          theme::code_keyword, theme::code_type,
                                       theme::code_call,     theme::code_number,  theme::dim,
                                       theme::code_directive};
    return colors[static_cast<std::size_t>(kind)];
}

/// A stage as it is shown.
struct ShownStage {
    const char* name;
    const Stage* stage;
    std::vector<std::string_view> lines;
    std::vector<SourceMatch> matches;
    std::size_t first_match = 0;  // matches of the stages before
};

float width_of(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

// Code in colours, with the matches of the search behind it.
void draw_code(std::string_view text, bool starts_in_comment, std::span<const SourceMatch> matches,
               const SourceMatch* chosen) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    for (const SourceMatch& match : matches) {
        const float left = start.x + width_of(text.substr(0, match.begin));
        const float right = left + width_of(text.substr(match.begin, match.end - match.begin));
        const ImVec2 end(right, start.y + ImGui::GetFontSize());
        list.AddRectFilled({left, start.y}, end, ImGui::GetColorU32(theme::code_match));
        if (chosen && *chosen == match)
            list.AddRect({left, start.y}, end, ImGui::GetColorU32(theme::accent));
    }
    float left = start.x;
    for (const CodeSpan& span : code_spans(text, starts_in_comment)) {
        const std::string_view part = text.substr(span.begin, span.end - span.begin);
        list.AddText({left, start.y}, ImGui::GetColorU32(color_of(span.kind)), part.data(),
                     part.data() + part.size());
        left += width_of(part);
    }
    ImGui::Dummy({left - start.x, ImGui::GetFontSize()});
}

/// A line of a stage.
struct ShownLine {
    int number = 0;
    std::string_view text;
    Location origin;
    bool starts_in_comment = false;
    std::span<const SourceMatch> matches = {};
};

void draw_line(const ShownLine& line, const SourceMatch* chosen, float width, Edits& edits) {
    const ScopedId id(line.number);
    const float left = ImGui::GetCursorPosX();
    const float gap = ImGui::GetFontSize();
    const bool is_chosen = ImGui::Selectable("##line");
    if (!line.origin.file.empty()) {
        edits.mark("text_line:" + origin_text(line.origin));
        editor_tooltip(line.origin.file);
        if (is_chosen)
            edits.change(
                [origin = line.origin](LookCommands& looks) { looks.open_in_editor(origin); });
    }
    const std::string number_text = fmt::format("{:>4}", line.number);
    ImGui::SameLine(left);
    dim_text(number_text);
    ImGui::SameLine(left + ImGui::CalcTextSize(number_text.c_str()).x + gap);
    dim_text(origin_text(line.origin));
    ImGui::SameLine(left + ImGui::CalcTextSize(number_text.c_str()).x + width + 2.0f * gap);
    draw_code(line.text, line.starts_in_comment, line.matches, chosen);
}

std::span<const SourceMatch> matches_of_line(const ShownStage& shown, std::size_t line) {
    const auto found = std::ranges::equal_range(shown.matches, line, {}, &SourceMatch::line);
    return {found.begin(), found.end()};
}

void draw_lines(const ShownStage& shown, const SourceMatch* chosen, bool scrolls, Edits& edits) {
    const Stage& stage = *shown.stage;
    const float width = origin_width(stage);
    const std::vector<bool> in_comments = lines_in_comments(shown.lines);
    const float step = ImGui::GetTextLineHeightWithSpacing();
    if (chosen && scrolls)
        ImGui::SetScrollFromPosY(ImGui::GetCursorScreenPos().y - ImGui::GetWindowPos().y +
                                     step * static_cast<float>(chosen->line),
                                 0.4f);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown.lines.size()), step);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto line = static_cast<std::size_t>(i);
            draw_line({i + 1, shown.lines[line],
                       stage.lines.empty() ? Location{} : origin_of(stage.lines, i + 1),
                       in_comments[line], matches_of_line(shown, line)},
                      chosen, width, edits);
        }
    clipper.End();
}

void draw_stage(const ShownStage& shown, const SourceSearch& search, Edits& edits) {
    const bool has_chosen = search.match >= shown.first_match &&
                            search.match - shown.first_match < shown.matches.size();
    if (has_chosen && search.scrolls)
        open_section(shown.name);
    if (!section(shown.name, true))
        return;
    const ScopedId id(shown.name);
    draw_lines(shown, has_chosen ? &shown.matches[search.match - shown.first_match] : nullptr,
               search.scrolls, edits);
}

void choose_match(std::size_t match, Edits& edits) {
    edits.arrange([match](WindowState& window) {
        window.views.source.match = match;
        window.views.source.scrolls = true;
    });
}

// The search box, its matches, and a button that copies each stage.
void draw_tools(std::span<const ShownStage> stages, std::size_t count, const SourceSearch& search,
                Edits& edits) {
    std::string text = search.text;
    bool is_entered = false;
    if (draw_search_box({"source_search", "Search the source", ImGui::GetFontSize() * 15.0f, false,
                         &is_entered},
                        text, edits))
        edits.arrange([text](WindowState& window) {
            window.views.source = {text, 0, !text.empty()};
        });
    if (!search.text.empty()) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        dim_text(count == 0
                     ? "No matches"
                     : fmt::format("{} of {}", std::min(search.match, count - 1) + 1, count));
        edits.mark("source_matches");
    }
    if (count > 1) {
        ImGui::SameLine();
        if (icon_button("##previous", Icon::up, "Previous match", theme::label))
            choose_match((search.match + count - 1) % count, edits);
        edits.mark("source_previous");
        ImGui::SameLine(0.0f, 0.0f);
        if (icon_button("##next", Icon::down, "Next match (Enter in the search box)",
                        theme::label) ||
            is_entered)
            choose_match((search.match + 1) % count, edits);
        edits.mark("source_next");
    }
    for (const ShownStage& shown : stages) {
        ImGui::SameLine();
        const std::string label = fmt::format("Copy {}", to_lower(shown.name));
        if (quiet_button(label))
            edits.copy(shown.stage->text);
        edits.mark("source_copy:" + std::string(shown.name));
    }
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
    const SourceSearch& search = scene.window.views.source;
    std::array stages{
        ShownStage{"Fragment shader", &pass.fragment, {}, {}},
        ShownStage{"Vertex shader", pass.vertex.text->empty() ? &own : &pass.vertex, {}, {}}};
    std::size_t count = 0;
    for (ShownStage& shown : stages) {
        shown.lines = split_lines(shown.stage->text);
        shown.matches = find_matches(shown.lines, search.text);
        shown.first_match = std::exchange(count, count + shown.matches.size());
    }
    draw_tools(stages, count, search, edits);
    ImGui::BeginChild("##source", {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
    {
        const ScopedFont font(scene.fonts.numbers);
        for (const ShownStage& shown : stages)
            draw_stage(shown, search, edits);
    }
    ImGui::EndChild();
    if (search.scrolls)
        edits.arrange([](WindowState& window) { window.views.source.scrolls = false; });
}
