#include "ui/parameters_panel.h"

#include "base/text.h"
#include "ui/icons.h"
#include "ui/parameter_control.h"
#include "ui/reveal.h"
#include "ui/scoped.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <imgui/imgui_stdlib.h>

#include <algorithm>

namespace {
struct Group {
    std::string name;
    std::vector<const Parameter*> parameters;
};

bool is_sought(const Parameter& parameter, const std::string& group, const std::string& words) {
    const std::string text = to_lower(parameter.name + ' ' + parameter.label + ' ' + group + ' ' +
                                      parameter.unit + ' ' + parameter.help);
    const std::string lower = to_lower(words);
    const auto sought = split(lower, ' ');
    return std::all_of(sought.begin(), sought.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

std::vector<Group> groups_to_show(const Document& document, const WindowState& window) {
    std::vector<Group> groups;
    for (const Parameter& parameter : document.look().parameters) {
        const std::string name = heading_of(document.look(), parameter);
        if (parameter.is_hidden || !is_sought(parameter, name, window.search) ||
            (window.shows_only_changed && !document.is_changed(parameter)))
            continue;
        const auto found = std::find_if(groups.begin(), groups.end(),
                                        [&](const Group& group) { return group.name == name; });
        Group& group = found == groups.end() ? groups.emplace_back(Group{name, {}}) : *found;
        group.parameters.push_back(&parameter);
    }
    return groups;
}

void draw_search(const WindowState& window, Edits& edits) {
    const float buttons = ImGui::GetFrameHeight() * 2.0f + ImGui::GetStyle().ItemSpacing.x * 2.0f;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - buttons -
                            ImGui::CalcTextSize("Changed").x);
    if (window.is_searching) {
        ImGui::SetKeyboardFocusHere();
        edits.arrange([](WindowState& state) { state.is_searching = false; });
    }
    std::string words = window.search;
    if (ImGui::InputTextWithHint("##search", "Search parameters", &words))
        edits.arrange([words](WindowState& state) { state.search = words; });
    edits.mark("search");
}

void draw_toolbar(const Document& document, const WindowState& window, Edits& edits) {
    draw_search(window, edits);
    ImGui::SameLine();
    {
        const ScopedColor text(ImGuiCol_Text,
                               window.shows_only_changed ? theme::accent : theme::dim);
        if (quiet_button("Changed"))
            edits.arrange(
                [](WindowState& state) { state.shows_only_changed = !state.shows_only_changed; });
        tooltip("Show only the parameters that differ from their defaults");
    }
    ImGui::SameLine(0.0f, 0.0f);
    const bool can_reset = !document.values().empty();
    const ScopedDisabled disabled(!can_reset);
    if (icon_button("##reset_all", Icon::reset, "Reset every parameter",
                    can_reset ? theme::text : theme::faint) &&
        can_reset)
        edits.document([](Document& changed) { changed.reset_all(); });
    edits.mark("reset_all");
}

void draw_group_header_end(const Group& group, std::size_t changed, Edits& edits) {
    if (changed == 0)
        return;
    same_line_right(ImGui::GetFrameHeight());
    const bool is_asked = icon_button("##reset_group", Icon::reset, "Reset this group", theme::dim);
    edits.mark("reset_group:" + group.name);
    if (!is_asked)
        return;
    std::vector<std::string> names;
    for (const Parameter* parameter : group.parameters)
        names.push_back(parameter->name);
    edits.document([names](Document& document) { document.reset(names); });
}

void draw_group(const Group& group, const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document();
    const ScopedId id(group.name);
    const auto changed = static_cast<std::size_t>(
        std::count_if(group.parameters.begin(), group.parameters.end(),
                      [&](const Parameter* parameter) { return document.is_changed(*parameter); }));
    bool is_open = false;
    {
        const ScopedFont strong(scene.fonts.strong);
        const std::string title = group.name.empty() ? "Parameters" : group.name;
        if (is_to_be_shown(group.parameters, scene.window))
            open_section(title);
        is_open = section(title, true) || !scene.window.search.empty();
        edits.mark("group:" + group.name);
    }
    draw_group_header_end(group, changed, edits);
    if (!is_open)
        return;
    for (const Parameter* parameter : group.parameters) {
        const float top = ImGui::GetCursorPosY();
        draw_parameter({*parameter, document.value(*parameter), document.is_changed(*parameter)},
                       scene.fonts, edits);
        show_if_revealed(*parameter, top, scene.window, edits);
    }
    ImGui::Spacing();
}

void draw_nothing_to_show(const Document& document, const WindowState& window, Edits& edits) {
    if (document.look().parameters.empty()) {
        wrapped_dim_text(
            "This look has no parameters: a uniform in one of its shaders becomes one.");
        return;
    }
    dim_text(window.shows_only_changed ? "Nothing is changed." : "No parameter matches.");
    if (quiet_button("Show all"))
        edits.arrange([](WindowState& state) {
            state.search.clear();
            state.shows_only_changed = false;
        });
    edits.mark("show_all");
}

void draw_orphans(const Document& document) {
    const std::vector<std::string> names = orphans(document.look(), document.values());
    if (names.empty())
        return;
    ImGui::Separator();
    heading("Kept for a parameter that this look no longer has");
    for (const std::string& name : names)
        fitted_text(name + " = " + to_string(document.values().at(name)),
                    ImGui::GetContentRegionAvail().x, theme::dim);
}
}  // namespace

void draw_parameters_panel(const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document();
    if (!document)
        return;
    draw_toolbar(*document, scene.window, edits);
    ImGui::Spacing();
    {  // of the list alone: what pops up above it has its own
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##groups");
    }
    const std::vector<Group> groups = groups_to_show(*document, scene.window);
    for (const Group& group : groups)
        draw_group(group, scene, edits);
    if (groups.empty())
        draw_nothing_to_show(*document, scene.window, edits);
    draw_orphans(*document);
    ImGui::EndChild();
}
