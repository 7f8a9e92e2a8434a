#include "ui/parameters/parameters_panel.h"

#include "lab/document/parameter_edits.h"
#include "lab/document/parameter_effect.h"
#include "lab/menus/parameter_menu.h"
#include "lab/previews/previews.h"
#include "lab/remote/remote_control.h"
#include "lab/window/parameter_list.h"
#include "model/tuning/slider_range.h"
#include "ui/frame/action.h"
#include "ui/parameters/parameter_control.h"
#include "ui/parameters/reveal.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/search_box.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace {
void draw_search(const WindowState& window, float width, Edits& edits) {
    const bool wants_focus = window.parameters.is_searching;
    if (wants_focus)
        edits.arrange([](WindowState& state) { state.parameters.is_searching = false; });
    std::string search = window.parameters.search;
    if (draw_search_box({"search", "Search parameters", width, wants_focus}, search, edits))
        edits.arrange([search](WindowState& state) { state.parameters.search = search; });
}

struct FilterChoice {
    ParameterFilter filter;
    const char* name;   // on the button
    const char* label;  // in the list
};
constexpr std::array<FilterChoice, 4> filters{
    {{ParameterFilter::all, "All", "All parameters"},
     {ParameterFilter::changed, "Changed", "Changed parameters"},
     {ParameterFilter::favourites, "Favourites", "Favourites"},
     {ParameterFilter::of_pass, "This pass", "Used by this pass"}}};

float filter_width() {
    return ImGui::CalcTextSize("Favourites").x + ImGui::GetFontSize() * 1.9f;
}

void draw_filter(const WindowState& window, Edits& edits) {
    const auto& current =
        *std::ranges::find(filters, window.parameters.filter, &FilterChoice::filter);
    const bool is_all = window.parameters.filter == ParameterFilter::all;
    bool is_open = false;
    {
        const ScopedColor text(ImGuiCol_Text, is_all ? theme::dim : theme::accent);
        is_open = begin_combo("##filter", current.name, filter_width());
    }
    if (!is_open) {
        tooltip("Filter parameters");
        edits.mark("filter");
        return;
    }
    for (const FilterChoice& choice : filters) {
        const bool is_of_pass = choice.filter == ParameterFilter::of_pass;
        const std::string label =
            is_of_pass ? fmt::format("Used by {}", window.views.inspected.pass) : choice.label;
        if ((!is_of_pass || !window.views.inspected.pass.empty()) &&
            ImGui::Selectable(label.c_str(), choice.filter == window.parameters.filter))
            edits.arrange(
                [chosen = choice.filter](WindowState& state) { state.parameters.filter = chosen; });
        edits.mark(std::string("filter:") + choice.name);
    }
    ImGui::EndCombo();
}

void draw_randomise_button(const Scene& scene, Edits& edits) {
    const double strength = scene.window.parameters.random_strength;
    const auto* const present =
        std::ranges::find(random_strengths, strength, &std::pair<double, const char*>::first);
    const std::string how_far = present == random_strengths.end() ? "" : present->second;
    if (icon_button("##randomise", Icon::dice,
                    fmt::format("{}\nStrength: {}. Right-click to change it.",
                                scene.actions.help(ActionId::randomise), how_far),
                    theme::text))
        run(ActionId::randomise, scene, edits);
    edits.mark("randomise");
    if (!ImGui::BeginPopupContextItem("##random_strength"))
        return;
    for (const auto& [choice, name] : random_strengths) {
        if (ImGui::MenuItem(name, nullptr, choice == strength))
            edits.arrange([chosen = choice](WindowState& state) {
                state.parameters.random_strength = chosen;
            });
        edits.mark(fmt::format("random_strength:{:g}", choice));
    }
    ImGui::EndPopup();
}

void draw_toolbar(const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float rest = filter_width() + 2.0f * ImGui::GetFrameHeight() + 2.0f * gap;
    draw_search(scene.window, ImGui::GetContentRegionAvail().x - rest, edits);
    ImGui::SameLine();
    draw_filter(scene.window, edits);
    ImGui::SameLine();
    draw_randomise_button(scene, edits);
    ImGui::SameLine(0.0f, 0.0f);
    const bool can_reset = !document.values().empty();
    const ScopedDisabled disabled(!can_reset);
    if (icon_button("##reset_all", Icon::reset, "Reset all unlocked parameters",
                    can_reset ? theme::text : theme::faint) &&
        can_reset)
        edits.change([](Document& changed) { reset_all_parameters(changed); });
    edits.mark("reset_all");
}

void draw_group_reset(const ParameterGroup& group, Edits& edits) {
    const bool is_asked = icon_button("##reset_group", Icon::reset,
                                      "Reset unlocked parameters in this group", theme::dim);
    edits.mark("reset_group:" + group.name);
    if (!is_asked)
        return;
    std::vector<std::string> names;
    for (const Parameter* parameter : group.parameters)
        names.push_back(parameter->name);
    edits.change([names](Document& document) { reset_group(document, names); });
}

// The buttons of a heading. The die is only drawn under the pointer.
void draw_group_buttons(const ParameterGroup& group, bool has_changes, const Scene& scene,
                        Edits& edits) {
    const float size = ImGui::GetFrameHeight();
    const float top = ImGui::GetItemRectMin().y;
    const float left = ImGui::GetWindowPos().x;
    const bool is_pointed =
        ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
        ImGui::IsMouseHoveringRect({left, top}, {left + ImGui::GetWindowWidth(), top + size});
    same_line_right(2.0f * size);
    if (is_pointed && can_be_randomised(scene.lab.document->look(), group)) {
        if (icon_button("##randomise_group", Icon::dice,
                        "Randomise unlocked parameters in this group", theme::dim))
            edits.change(randomise_group(group, scene.window.parameters.random_strength));
        edits.mark("randomise_group:" + group.name);
    } else {
        ImGui::Dummy({size, size});
    }
    ImGui::SameLine(0.0f, 0.0f);
    if (has_changes)
        draw_group_reset(group, edits);
    else
        ImGui::Dummy({size, size});
}

/// A row of the list. Outside the visible area it only reserves the height of its last drawing.
class ParameterRow {
public:
    explicit ParameterRow(const Parameter& parameter)
        : m_id(ImGui::GetID(parameter.name.c_str())), m_top(ImGui::GetCursorScreenPos().y) {
        m_lines = m_storage.GetFloat(m_id, static_cast<float>(expected_lines(parameter)));
    }

    /// With a margin of one line, so that keyboard navigation reaches the next row. A row that is
    /// being dragged is always drawn.
    bool is_in_sight() const {
        const float line = ImGui::GetFrameHeightWithSpacing();
        const float top = ImGui::GetWindowPos().y - line;
        const float bottom = top + ImGui::GetWindowHeight() + 2.0f * line;
        return (m_top < bottom && m_top + m_lines * line > top) || m_storage.GetBool(m_id + 1);
    }
    void pass_over() const {
        const float height = m_lines * ImGui::GetFrameHeightWithSpacing();
        ImGui::Dummy({0.0f, height - ImGui::GetStyle().ItemSpacing.y});
    }
    void end(bool is_held) {
        const float height = ImGui::GetCursorScreenPos().y - m_top;
        m_storage.SetFloat(m_id, height / ImGui::GetFrameHeightWithSpacing());
        m_storage.SetBool(m_id + 1, is_held);
    }

private:
    ImGuiStorage& m_storage = *ImGui::GetStateStorage();
    ImGuiID m_id;
    float m_top;
    float m_lines = 1.0f;
};

PeriodInfo period_info(const Parameter& parameter, const Scene& scene) {
    if (parameter.type.size() != 1)
        return {};
    const Document& document = *scene.lab.document;
    return period_info(parameter, document.value(parameter).number(),
                       period_terms(parameter, document, scene.lab.renderer));
}

// Of the labels before a slider, whatever the list is filtered to.
float longest_label(const Look& look) {
    float longest = 8.5f * ImGui::GetFontSize();  // a short name, and its star and padlock
    for (const Parameter& parameter : look.parameters)
        if (!parameter.is_hidden && !has_parts(parameter) &&
            parameter.type.scalar != Scalar::boolean)
            longest = std::max(longest, ImGui::CalcTextSize(parameter.label.c_str()).x);
    return longest;
}

void draw_parameter_row(const Parameter& parameter, float label_width, const Scene& scene,
                        Edits& edits) {
    const Document& document = *scene.lab.document;
    ParameterRow row(parameter);
    // Controls out of sight can get the focus.
    if (!row.is_in_sight() && !scene.window.keyboard.has_focus) {
        row.pass_over();
        return;
    }
    const ParameterSetting& setting = setting_of(parameter.name, document.parameter_settings());
    const auto own = setting.ends ? std::optional(with_ends(parameter, setting)) : std::nullopt;
    ParameterEntry entry{
        .parameter = own ? *own : parameter,
        .value = document.value(parameter),
        .is_changed = is_changed(document, parameter),
        .setting = setting,
        .declared = parameter.range,
        .look = document.look(),
        .modulation = modulation_of(document, parameter),
        .period = period_info(parameter, scene),
        .midi = bindings_of(parameter, document.look(), scene.lab.remote.settings()),
        .without_effect = why_without_effect(
            document, parameter, scene.lab.frames.previews().effects().has_effect(parameter.name)),
        .longest_label = label_width};
    const Revealed& revealed = scene.window.parameters.revealed;
    if (revealed.wants_focus && revealed.parameter == parameter.name)
        entry.typed = revealed.component;
    if (entry.modulation && scene.lab.renderer)
        entry.now = &value_of(parameter, scene.lab.renderer->executor().graph().values());
    row.end(draw_parameter(entry, scene, edits));
}

void draw_group(const ParameterGroup& group, float label_width, const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document;
    const ScopedId id(group.name);
    const auto changed = static_cast<std::size_t>(std::count_if(
        group.parameters.begin(), group.parameters.end(),
        [&](const Parameter* parameter) { return is_changed(document, *parameter); }));
    bool is_open = false;
    {
        const ScopedFont strong(scene.fonts.strong);
        const std::string title = group.name.empty() ? "Parameters" : group.name;
        if (is_to_be_shown(group.parameters, scene.window.parameters))
            open_section(title);
        is_open = section(title, true, 2) || !scene.window.parameters.search.empty();
        edits.mark("group:" + group.name);
    }
    draw_group_buttons(group, changed > 0, scene, edits);
    if (!is_open)
        return;
    for (const Parameter* parameter : group.parameters) {
        const float top = ImGui::GetCursorPosY();
        draw_parameter_row(*parameter, label_width, scene, edits);
        show_if_revealed(*parameter, top, scene.window.parameters, edits);
    }
    ImGui::Spacing();
}

void draw_nothing_to_show(const Document& document, const WindowState& window, Edits& edits) {
    if (document.look().parameters.empty()) {
        wrapped_dim_text(
            "This look has no parameters. Each uniform that you add to its shaders becomes one.");
        return;
    }
    wrapped_dim_text(empty_list_text(query_of(window)));
    if (quiet_button("Show all"))
        edits.arrange([](WindowState& state) {
            state.parameters.search.clear();
            state.parameters.filter = ParameterFilter::all;
        });
    edits.mark("show_all");
}

void draw_orphans(const Document& document) {
    const std::vector<std::string> names = orphans(document.look(), document.values());
    if (names.empty())
        return;
    ImGui::Separator();
    heading("Values of missing parameters");
    for (const std::string& name : names)
        fitted_text(fmt::format("{} = {}", name, to_string(document.values().at(name))),
                    ImGui::GetContentRegionAvail().x, theme::dim);
}
// Clears search and scroll position for another look. Returns whether it is another look.
bool begin_list(const Document& document, const WindowState& window, Edits& edits) {
    const std::string look = document.look().manifest.string();
    if (window.parameters.listed_look == look)
        return false;
    edits.arrange([look, is_first = window.parameters.listed_look.empty()](WindowState& state) {
        state.parameters.listed_look = look;
        if (!is_first)
            state.parameters.search.clear();
    });
    return true;
}
}  // namespace

void draw_parameters_panel(const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document;
    if (!document)
        return;
    const bool is_other = begin_list(*document, scene.window, edits);
    draw_toolbar(scene, edits);
    ImGui::Spacing();
    {  // only for the list: popups above it keep their own padding
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##groups", {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
    }
    if (is_other)
        ImGui::SetScrollY(0.0f);
    const std::vector<ParameterGroup> groups = listed_parameters(*document, query_of(scene.window));
    const float label_width = longest_label(document->look());
    for (const ParameterGroup& group : groups)
        draw_group(group, label_width, scene, edits);
    if (groups.empty())
        draw_nothing_to_show(*document, scene.window, edits);
    draw_orphans(*document);
    ImGui::EndChild();
}
