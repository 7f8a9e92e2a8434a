#include "ui/picture/overlays.h"

#include "lab/commands/look_commands.h"
#include "lab/commands/preset_commands.h"
#include "lab/document/morphing.h"
#include "lab/previews/previews.h"
#include "lab/reload/look_loader.h"
#include "lab/remote/remote_control.h"
#include "lab/storage/display_name.h"
#include "ui/picture/compare_bar.h"
#include "ui/picture/first_steps.h"
#include "ui/picture/offer.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/problem_list.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
void draw_centered(const std::string& text, float y, const ImVec4& color) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPos({(ImGui::GetWindowWidth() - width) * 0.5f, y});
    const ScopedColor scoped(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
}

std::vector<const Problem*> errors_of(const Messages& messages) {
    std::vector<const Problem*> errors;
    for (const Problem& problem : messages.problems())
        if (problem.diagnostic.severity == Severity::error)
            errors.push_back(&problem);
    return errors;
}

// Height of a problem as draw_problem() draws it: location and message, then the source lines.
float height_of(const Problem& problem, float width) {
    const std::string text =
        display_name(problem.diagnostic.file) + ":9999  " + problem.diagnostic.message;
    const float message = ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
    return message + ImGui::GetStyle().ItemSpacing.y + excerpt_height(problem);
}

// The heading for errors of a look that could not be opened.
std::string headline_of(const LookLoader& loader, const Document* document) {
    if (loader.failed().empty() || !document)
        return {};
    return fmt::format("Can't open \"{}\". {} is still open.", loader.failed(),
                       document->look().name);
}

void draw_errors(const Scene& scene, Edits& edits) {
    if (!shows_errors(scene))
        return;
    const std::vector<const Problem*> errors = errors_of(scene.lab.messages);
    constexpr std::size_t maximum = 4;
    const float side = ImGui::GetFrameHeight();
    const std::string headline = headline_of(scene.lab.loader, scene.lab.document);
    const float margin = ImGui::GetFontSize() * 0.7f;
    const float width = ImGui::GetWindowWidth() - 2.0f * margin;
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const ImGuiStyle& style = ImGui::GetStyle();
    const float inner = width - 2.0f * style.WindowPadding.x - side;
    float height = 2.0f * style.WindowPadding.y + (errors.size() > maximum ? line : 0.0f) +
                   (headline.empty() ? 0.0f : line);
    for (std::size_t i = 0; i < std::min(errors.size(), maximum); ++i)
        height += height_of(*errors[i], inner) + style.ItemSpacing.y;
    height = std::min(height, ImGui::GetWindowHeight() * 0.6f);
    ImGui::SetCursorPos({margin, margin});
    const ScopedColor back(ImGuiCol_ChildBg, theme::problem_pane);
    const ScopedStyle<float> rounding(ImGuiStyleVar_ChildRounding, 5.0f * scene.scale);
    ImGui::BeginChild("##errors", {width, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    {  // only for the list
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##list", {inner, 0.0f});
    }
    if (!headline.empty())
        fitted_text(headline, inner, theme::text);
    for (std::size_t i = 0; i < std::min(errors.size(), maximum); ++i) {
        draw_problem(*errors[i], scene.fonts, edits);
        ImGui::Spacing();
    }
    if (errors.size() > maximum)
        dim_text(fmt::format("{} more in the Problems list", errors.size() - maximum));
    ImGui::EndChild();
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##away", Icon::close, "Dismiss (Esc). The Problems list keeps these errors.",
                    theme::label))
        edits.change([](LookCommands& looks) { looks.dismiss_problems(); });
    edits.mark("errors_away");
    ImGui::EndChild();
    edits.mark("errors");
}

struct Pill {
    const char* id;
    std::string text;
    theme::Color color;
    float rise = 0.0f;  // above the bottom, in lines
    float opacity = 1.0f;
};

void draw_pill(const Pill& pill, const Scene& scene) {
    const float pad = ImGui::GetFontSize() * 0.8f;
    const float maximum = ImGui::GetWindowWidth() * 0.8f - 2.0f * pad;
    const std::string text = wrapped(pill.text, maximum);
    const ImVec2 text_size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 size(text_size.x + 2.0f * pad, text_size.y + pad);
    const ImVec2 window = ImGui::GetWindowPos();
    const float bottom = window.y + ImGui::GetWindowHeight() - compare_bar_height(scene) - pad -
                         pill.rise * size.y * 1.3f;
    const ImVec2 low(window.x + (ImGui::GetWindowWidth() - size.x) * 0.5f, bottom - size.y);
    const ScopedStyle<float> opacity(ImGuiStyleVar_Alpha, pill.opacity);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x, bottom}, ImGui::GetColorU32(theme::popup),
                       6.0f * scene.scale);
    list.AddRect(low, {low.x + size.x, bottom}, ImGui::GetColorU32(theme::line),
                 6.0f * scene.scale);
    list.AddText(scene.fonts.text, ImGui::GetFontSize(), {low.x + pad, low.y + pad * 0.5f},
                 ImGui::GetColorU32(pill.color), text.c_str());
}

void draw_notice(const Scene& scene, Edits& edits) {
    const auto& notice = scene.lab.messages.notice();
    if (!notice)
        return;
    if (!notice->buttons.empty())
        return draw_offer(*notice, scene, edits);
    const float opacity = std::clamp(static_cast<float>(notice->seconds_left), 0.0f, 1.0f);
    const theme::Color color = notice->is_problem   ? theme::problem
                               : notice->is_warning ? theme::warning
                                                    : theme::text;
    draw_pill({"##notice", notice->text, color, 0.0f, opacity}, scene);
}

void draw_replay(const Scene& scene) {
    if (!scene.lab.renderer || !scene.lab.renderer->replay().is_running())
        return;
    const Replay& replay = scene.lab.renderer->replay();
    draw_pill({"##replay",
               fmt::format("Replaying frame {} of {} · Esc to stop", replay.done(), replay.total()),
               theme::dim, 1.0f},
              scene);
}

// The non-finite pixel that stopped the clock, with buttons for the possible actions.
void draw_non_finite(const Scene& scene, Edits& edits) {
    const auto& trip = scene.lab.frames.nan_guard().found();
    if (!trip || !scene.lab.renderer)
        return;
    const std::string& pass = scene.lab.renderer->executor().look().passes[trip->pass].name;
    const std::string text =
        fmt::format("Paused: pass \"{}\" wrote NaN/Inf at pixel ({}, {}), frame {}.", pass, trip->x,
                    trip->y, trip->frame);
    const float margin = ImGui::GetFontSize() * 0.7f;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::GetWindowWidth() - 2.0f * margin;
    const float inner = width - 2.0f * style.WindowPadding.x;
    const float height = ImGui::CalcTextSize(text.c_str(), nullptr, false, inner).y +
                         2.0f * style.WindowPadding.y + style.ItemSpacing.y +
                         ImGui::GetFrameHeight();
    ImGui::SetCursorPos({margin, margin});
    const ScopedColor back(ImGuiCol_ChildBg, theme::problem_pane);
    const ScopedStyle<float> rounding(ImGuiStyleVar_ChildRounding, 5.0f * scene.scale);
    ImGui::BeginChild("##trip", {width, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::TextWrapped("%s", text.c_str());
    struct NanButton {
        NonFiniteAction answer;
        const char* label;
        const char* help;
        const char* name;
    };
    for (const NanButton& button :
         {NanButton{NonFiniteAction::clear, "Restart history", "Clears the history and continues.",
                    "trip_clear"},
          NanButton{NonFiniteAction::clamp, "Clamp",
                    "Replaces NaN with 0 and Inf with the largest number, in every pass.",
                    "trip_clamp"},
          NanButton{NonFiniteAction::ignore, "Ignore",
                    "Ignores NaN and Inf until the look is edited.", "trip_go_on"}}) {
        if (ImGui::Button(button.label))
            edits.change([answer = button.answer](FrameLoop& frames) {
                frames.nan_guard().set_action(answer);
            });
        edits.mark(button.name);
        tooltip(button.help);
        ImGui::SameLine();
    }
    if (quiet_button("Show pass"))
        edits.arrange([pass](WindowState& window) {
            window.views.inspected.inspect(pass);
            window.views.inspected.marks_flaws = true;
            window.layout.panels.show(panel_id::inspector);
        });
    edits.mark("trip_show");
    ImGui::EndChild();
}

std::string opening_text(const LookLoader::Opening& opening) {
    return fmt::format("Opening {} · {} · Esc to cancel", opening.look,
                       to_string(opening.progress));
}

void draw_loading(const Scene& scene) {
    const std::filesystem::path file = scene.lab.media.loading();
    const auto opening = scene.lab.loader.opening();
    if (file.empty() && opening && scene.lab.document)
        draw_pill({"##loading", opening_text(*opening), theme::dim, 2.0f}, scene);
    if (file.empty())
        return;
    draw_pill({"##loading",
               fmt::format("Loading {}: {:.0f} % · Esc to cancel", file.filename().string(),
                           100.0 * scene.lab.media.loaded_share()),
               theme::dim, 2.0f},
              scene);
}

void draw_step(const Scene& scene, Edits& edits) {
    const StepProbe& probe = scene.lab.frames.previews().probe();
    if (!probe.request() || probe.text().empty())
        return;
    const bool changes_nothing =
        probe.has_failed() || (probe.effect() && probe.effect()->kind != StepEffect::Kind::seen);
    draw_pill({"##step", probe.text(), changes_nothing ? theme::warning : theme::text, 1.0f},
              scene);
    edits.mark("step");
}

void draw_morph(const Scene& scene) {
    if (const Morphing* morphing = scene.lab.presets.navigation().morphing())
        draw_pill({"##morph",
                   fmt::format("Morphing to \"{}\": {:.0f} % · Esc to stop", morphing->name(),
                               100.0 * morphing->share()),
                   theme::dim, 2.0f},
                  scene);
}

void draw_command_learning(const Scene& scene, Edits& edits) {
    const std::string name = scene.lab.remote.learning_name();
    if (name.empty())
        return;
    draw_pill(
        {"##midi", fmt::format("Press a MIDI pad, key or button for \"{}\" · Esc to cancel", name),
         theme::accent, 2.0f},
        scene);
    edits.mark("midi_learning");
}

void draw_midi_learning(const Scene& scene, Edits& edits) {
    const auto& goal = scene.lab.remote.midi().learning();
    const Parameter* parameter = goal && scene.lab.document
                                     ? find_parameter(scene.lab.document->look(), goal->parameter)
                                     : nullptr;
    if (!parameter)
        return;
    draw_pill(
        {"##midi",
         fmt::format("Move a MIDI knob or fader for \"{}\" · Esc to cancel", parameter->label),
         theme::accent, 2.0f},
        scene);
    edits.mark("midi_learning");
}
}  // namespace

bool shows_errors(const Scene& scene) {
    return !scene.lab.messages.are_problems_dismissed() && !errors_of(scene.lab.messages).empty();
}

void draw_overlays(const Scene& scene, Edits& edits) {
    draw_first_steps(scene, edits);
    draw_errors(scene, edits);
    draw_non_finite(scene, edits);
    draw_loading(scene);
    draw_replay(scene);
    draw_morph(scene);
    draw_midi_learning(scene, edits);
    draw_command_learning(scene, edits);
    draw_step(scene, edits);
    draw_notice(scene, edits);
}

void draw_welcome(const Scene& scene) {
    const float middle = ImGui::GetWindowHeight() * 0.42f;
    const float line = ImGui::GetTextLineHeightWithSpacing();
    if (scene.lab.loader.is_loading()) {
        const auto opening = scene.lab.loader.opening();
        draw_centered(opening ? opening_text(*opening) : "Loading the look…", middle, theme::dim);
        return;
    }
    {
        const ScopedFont font(scene.fonts.strong);
        draw_centered("Afterglow", middle, theme::text);
    }
    draw_centered("Choose a look on the left, or drop a look, preset, picture or sound here.",
                  middle + line * 1.3f, theme::dim);
}
