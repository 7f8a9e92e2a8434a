#include "ui/playback/timeline_cues.h"

#include "lab/document/opened_preset.h"
#include "lab/lab.h"
#include "lab/library/cue_plans.h"
#include "lab/sequencer/sequencer.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace {
constexpr float marker_reach = 0.45f;  // of the font size

using CueVisitor = std::function<void(std::size_t line, const Cue& cue)>;

void for_each_cue(const Scene& scene, const CueVisitor& visit) {
    const auto& sheet = scene.lab.sequencer.cues().sheet();
    for (std::size_t i = 0; sheet && i < sheet->lines().size(); ++i)
        if (sheet->lines()[i].cue)
            visit(i + 1, *sheet->lines()[i].cue);
}

// While a marker is dragged, it is under the pointer.
double shown_time(const TimelineAxis& axis, std::size_t line, const Cue& cue, const Scene& scene) {
    const auto& drag = scene.window.views.timeline.drag;
    const bool is_dragged =
        drag && drag->kind == TimelineDrag::Kind::cue && drag->line == line && drag->has_moved;
    return is_dragged ? std::clamp(axis.time(ImGui::GetIO().MousePos.x), 0.0, axis.length)
                      : cue.seconds;
}

std::string marker_label(const Cue& cue) {
    switch (cue.command) {
        case Cue::Command::preset:
            return cue.name;
        case Cue::Command::parameter:
            return cue.name + " " + cue.value;
        case Cue::Command::restart:
            return "restart";
        case Cue::Command::blackout:
            break;
    }
    return cue.is_on ? "blackout on" : "blackout off";
}

const Diagnostic* problem_of(std::size_t line, const Scene& scene) {
    const Diagnostics& problems = scene.lab.sequencer.cues().problems();
    const auto found = std::ranges::find(problems, static_cast<int>(line), &Diagnostic::line);
    return found == problems.end() ? nullptr : &*found;
}

// Each from 'blackout on' to the next 'blackout' cue.
void draw_blackouts(const TimelineAxis& axis, const Scene& scene) {
    std::vector<std::pair<double, bool>> switches;
    for_each_cue(scene, [&](std::size_t, const Cue& cue) {
        if (cue.command == Cue::Command::blackout)
            switches.emplace_back(cue.seconds, cue.is_on);
    });
    std::ranges::stable_sort(switches, {}, &std::pair<double, bool>::first);
    for (std::size_t i = 0; i < switches.size(); ++i) {
        if (!switches[i].second)
            continue;
        const double end = i + 1 < switches.size() ? switches[i + 1].first : axis.length;
        ImGui::GetWindowDrawList()->AddRectFilled(
            {axis.x(switches[i].first), axis.high.y - axis.cues}, {axis.x(end), axis.high.y},
            theme::packed(theme::surround));
    }
}

void draw_marker(const TimelineAxis& axis, double time, const std::string& label,
                 const theme::Color& color, float room) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float x = std::floor(axis.x(time)) + 0.5f;
    const float top = axis.high.y - axis.cues;
    const float half = ImGui::GetFontSize() * 0.3f;
    list.AddLine({x, axis.low.y + axis.ruler}, {x, axis.high.y}, theme::packed(color));
    list.AddTriangleFilled({x, top}, {x + 2.0f * half, top + half}, {x, top + 2.0f * half},
                           theme::packed(color));
    const float left = x + 2.0f * half + 3.0f;
    const std::string text = elided_to_width(label, room - 2.0f * half - 8.0f);
    if (room > ImGui::GetFontSize() * 2.5f)
        list.AddText({left, top}, theme::packed(theme::label), text.c_str());
}

void type_cue(std::size_t line, std::string text, const TimelineAxis& axis, Edits& edits) {
    edits.arrange([typing = CueTyping{line, std::move(text), axis.mark}](WindowState& window) {
        window.views.timeline.typing = typing;
        window.views.timeline.drag.reset();
    });
}

// A new cue of the open preset at the pointer.
void type_new_cue(double seconds, const TimelineAxis& axis, const Scene& scene, Edits& edits) {
    const std::string preset = scene.lab.sequencer.cues().open_preset();
    type_cue(0,
             preset.empty() ? cue_time_text(seconds) + " preset \"\""
                            : cue_text({.seconds = seconds, .name = preset}),
             axis, edits);
}

const Cue& cue_in(std::size_t line, const Scene& scene) {
    return *scene.lab.sequencer.cues().sheet()->lines()[line - 1].cue;
}

void finish_typing(const CueTyping& typing, Edits& edits) {
    edits.change([typing](Lab& lab, WindowState& window) {
        if (!lab.document())
            return;
        const auto cue = parse_cue(typing.text);
        const Result<void> checked =
            cue ? check_cue(*cue, lab.document()->look(), lab.work().library) : fail(cue.error());
        if (!checked) {
            if (auto& open = window.views.timeline.typing) {
                open->problem = checked.error().front().message;
                open->wants_focus = true;
            }
            return;
        }
        window.views.timeline.typing.reset();
        if (typing.line == 0)
            lab.sequencer().cues().add(*cue);
        else
            lab.sequencer().cues().retype(typing.line, typing.text);
    });
}
}  // namespace

namespace {
struct Marker {
    double time = 0.0;
    std::string label;
    bool has_problem = false;
};

// Cues at the same place share a marker.
std::vector<Marker> markers(const TimelineAxis& axis, const Scene& scene) {
    std::vector<Marker> all;
    for_each_cue(scene, [&](std::size_t line, const Cue& cue) {
        all.push_back({shown_time(axis, line, cue, scene), marker_label(cue),
                       problem_of(line, scene) != nullptr});
    });
    std::ranges::stable_sort(all, {}, &Marker::time);
    std::vector<Marker> merged;
    for (Marker& marker : all) {
        if (merged.empty() || axis.x(marker.time) > axis.x(merged.back().time) + 0.5f) {
            merged.push_back(std::move(marker));
            continue;
        }
        merged.back().label += ", " + marker.label;
        merged.back().has_problem |= marker.has_problem;
    }
    return merged;
}
}  // namespace

void draw_cues(const TimelineAxis& axis, const Scene& scene) {
    if (axis.cues <= 0.0f)
        return;
    draw_blackouts(axis, scene);
    const bool is_active = scene.lab.sequencer.cues().is_playing();
    const std::vector<Marker> all = markers(axis, scene);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const float end = i + 1 < all.size() ? axis.x(all[i + 1].time) : axis.high.x;
        const theme::Color& color = all[i].has_problem ? theme::problem
                                    : is_active        ? theme::accent
                                                       : theme::dim;
        draw_marker(axis, all[i].time, all[i].label, color, end - axis.x(all[i].time));
    }
}

std::optional<std::size_t> cue_under(const TimelineAxis& axis, const ImVec2& pointer,
                                     const Scene& scene) {
    if (!axis.is_in_cues(pointer.y))
        return std::nullopt;
    const float reach = ImGui::GetFontSize() * marker_reach;
    std::optional<std::size_t> found;
    float nearest = 2.0f * reach;
    for_each_cue(scene, [&](std::size_t line, const Cue& cue) {
        const float off = pointer.x - axis.x(cue.seconds);
        if (off < -reach || off > 2.0f * reach || std::abs(off) > nearest)
            return;
        nearest = std::abs(off);
        found = line;
    });
    return found;
}

void move_cue(const TimelineAxis& axis, const TimelineDrag& drag, Edits& edits) {
    const double time = std::clamp(axis.time(ImGui::GetIO().MousePos.x), 0.0, axis.length);
    edits.change(
        [line = drag.line, time](Sequencer& sequencer) { sequencer.cues().move(line, time); });
}

bool type_cue_on_double_click(const TimelineAxis& axis, const Scene& scene, Edits& edits) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || !axis.is_in_cues(pointer.y))
        return false;
    if (const auto line = cue_under(axis, pointer, scene))
        type_cue(*line, cue_text(cue_in(*line, scene)), axis, edits);
    else
        type_new_cue(std::clamp(axis.time(pointer.x), 0.0, axis.length), axis, scene, edits);
    return true;
}

void draw_cue_items(const TimelineAxis& axis, const Scene& scene, Edits& edits) {
    const ImVec2 pointer = ImGui::GetMousePosOnOpeningCurrentPopup();
    ImGui::Separator();
    const auto line = cue_under(axis, pointer, scene);
    if (line && ImGui::MenuItem("Edit cue…"))
        type_cue(*line, cue_text(cue_in(*line, scene)), axis, edits);
    if (line && ImGui::MenuItem("Delete cue"))
        edits.change([line = *line](Sequencer& sequencer) { sequencer.cues().remove(line); });
    if (!line && ImGui::MenuItem("Add cue here…", nullptr, false, scene.lab.document != nullptr))
        type_new_cue(std::clamp(axis.time(pointer.x), 0.0, axis.length), axis, scene, edits);
    edits.mark("cue:add");
}

std::string cue_help(const TimelineAxis& axis, const Scene& scene) {
    const auto line = cue_under(axis, ImGui::GetIO().MousePos, scene);
    if (!line)
        return {};
    const Diagnostic* problem = problem_of(*line, scene);
    return cue_text(cue_in(*line, scene)) +
           (problem ? "\n" + problem->message : "\nDrag to move, double-click to edit.");
}

// Two lines are reserved, so that the popup stays within the window.
void draw_typing_problem(const char* mark, const CueTyping& typing, Edits& edits) {
    const float top = ImGui::GetCursorPosY();
    if (!typing.problem.empty()) {
        const ScopedColor color(ImGuiCol_Text, theme::problem);
        ImGui::TextUnformatted(wrapped(typing.problem, ImGui::GetFontSize() * 26.0f).c_str());
        edits.mark(std::string(mark) + ":cue_problem");
    }
    ImGui::SetCursorPosY(
        std::max(ImGui::GetCursorPosY(), top + 2.0f * ImGui::GetTextLineHeightWithSpacing()));
}

void draw_cue_typing(const char* mark, const Scene& scene, Edits& edits) {
    const auto& typing = scene.window.views.timeline.typing;
    const bool is_opening = typing && typing->is_new && typing->timeline == mark;
    if (is_opening) {
        ImGui::OpenPopup("##cue_text");
        edits.arrange([](WindowState& window) {
            if (window.views.timeline.typing)
                window.views.timeline.typing->is_new = false;
        });
    }
    if (!ImGui::BeginPopup("##cue_text"))
        return;
    if (!typing) {
        ImGui::CloseCurrentPopup();
        return ImGui::EndPopup();
    }
    std::string text = typing->text;
    if (ImGui::IsWindowAppearing() || typing->wants_focus)
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 26.0f);
    const bool is_entered = ImGui::InputText("##text", &text, ImGuiInputTextFlags_EnterReturnsTrue);
    edits.mark(std::string(mark) + ":cue");
    draw_typing_problem(mark, *typing, edits);
    dim_text(
        "TIME preset \"NAME\" morph S, parameter NAME VALUE over S, "
        "restart, blackout on|off");
    edits.arrange([text](WindowState& window) {
        if (auto& open = window.views.timeline.typing) {
            open->text = text;
            open->wants_focus = false;
        }
    });
    if (is_entered)
        finish_typing({typing->line, text}, edits);
    ImGui::EndPopup();
}

void draw_cue_line(const Scene& scene, Edits& edits) {
    const CueControl& cues = scene.lab.sequencer.cues();
    if (!cues.is_open()) {
        if (ImGui::Button("Open cues…"))
            run(ActionId::open_cues, scene, edits);
        edits.mark("open_cues");
        return;
    }
    bool is_playing = cues.is_playing();
    if (ImGui::Checkbox("Play cues", &is_playing))
        run(ActionId::play_cues, scene, edits);
    edits.mark("play_cues");
    tooltip("Apply the cues during playback. Turn off to use your own values.");
    ImGui::SameLine();
    const ScopedDisabled disabled(!cues.has_changes());
    if (ImGui::Button("Save cues"))
        run(ActionId::save_cues, scene, edits);
    edits.mark("save_cues");
    ImGui::SameLine();
    const std::string file = scene.lab.document->state().cues.file;
    std::string text =
        file.empty() ? "not saved yet" : std::filesystem::path(file).filename().string();
    if (!file.empty() && cues.has_changes())
        text += " (unsaved changes)";
    const bool has_problem = !cues.problems().empty();
    if (has_problem)
        text = to_string(cues.problems().front());
    ImGui::AlignTextToFramePadding();
    fitted_text(text, ImGui::GetContentRegionAvail().x, has_problem ? theme::problem : theme::dim);
}
