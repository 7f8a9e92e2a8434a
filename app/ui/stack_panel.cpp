#include "ui/stack_panel.h"

#include "ui/icons.h"
#include "ui/scoped.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <algorithm>

namespace {
// A part by its tag: what a person clicked on may have moved since.
void change(const std::string& tag, const std::string& step, Edits& edits,
            const std::function<void(Stack& stack, std::size_t part)>& change) {
    edits.document([tag, step, change](Document& document) {
        Stack stack = document.state().stack;
        const auto part = std::ranges::find(stack, tag, &StackPart::tag);
        if (part == stack.end())
            return;
        change(stack, static_cast<std::size_t>(part - stack.begin()));
        document.set_stack(std::move(stack), step);
    });
}

std::string name_of(const StackPart& part, const std::string& key, const Shelf& shelf) {
    const auto known = std::ranges::find_if(
        shelf.looks(), [&](const ShelfLook& look) { return look.entry.id == part.look; });
    const std::string name = known == shelf.looks().end() ? part.look : known->name;
    const std::size_t copy = key.find('#');
    return copy == std::string::npos ? name : name + ' ' + key.substr(copy + 1);
}

void draw_bypass(const StackPart& part, const std::string& key, const std::string& name,
                 Edits& edits) {
    bool is_drawn = !part.is_bypassed;
    if (ImGui::Checkbox("##drawn", &is_drawn))
        change(part.tag, (is_drawn ? "Draw " : "Bypass ") + name, edits,
               [is_drawn](Stack& stack, std::size_t i) { stack[i].is_bypassed = !is_drawn; });
    edits.mark("stack_bypass:" + key);
    tooltip(is_drawn ? "Bypass: the picture goes past this look" : "Draw this look again");
}

void draw_move(const char* id, int by, const StackPart& part, const std::string& name,
               bool is_possible, Edits& edits) {
    const ScopedDisabled disabled(!is_possible);
    const bool is_asked = icon_button(id, by < 0 ? Icon::up : Icon::down,
                                      by < 0 ? "Draw it earlier" : "Draw it later",
                                      is_possible ? theme::dim : theme::faint);
    if (is_asked && is_possible)
        change(part.tag, "Move " + name, edits, [by](Stack& stack, std::size_t i) {
            const auto other = static_cast<std::size_t>(static_cast<int>(i) + by);
            if (other < stack.size())
                std::swap(stack[i], stack[other]);
        });
}

void draw_part(const Stack& stack, std::size_t i, const Shelf& shelf, Edits& edits) {
    const StackPart& part = stack[i];
    const ScopedId id(part.tag);
    const std::string key = stack_keys(stack)[i];
    const std::string name = name_of(part, key, shelf);
    const float side = ImGui::GetFrameHeight();
    draw_bypass(part, key, name, edits);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    fitted_text(name, ImGui::GetContentRegionAvail().x - 3.0f * side,
                part.is_bypassed ? theme::dim : theme::text);
    const ScopedStyle<ImVec2> gap(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 2.0f));
    same_line_right(3.0f * side);
    draw_move("##up", -1, part, name, i > 0, edits);
    edits.mark("stack_up:" + key);
    ImGui::SameLine();
    draw_move("##down", 1, part, name, i + 1 < stack.size(), edits);
    edits.mark("stack_down:" + key);
    ImGui::SameLine();
    if (icon_button("##remove", Icon::close, "Take it out of the stack", theme::dim))
        change(part.tag, "Remove " + name, edits, [](Stack& left, std::size_t place) {
            if (left.size() > 1)
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(place));
        });
    edits.mark("stack_remove:" + key);
}

void draw_add(const Scene& scene, Edits& edits) {
    if (begin_combo("##add_look", "Add a look behind…", ImGui::GetContentRegionAvail().x)) {
        for (const ShelfLook& look : scene.shelf.looks()) {
            if (look.is_stack())
                continue;
            const ScopedId id(look.entry.folder.string());
            if (ImGui::Selectable(look.name.c_str()))
                add_to_stack(look, edits);
            edits.mark("stack_add:" + look.entry.id);
            tooltip(look.about);
        }
        ImGui::EndCombo();
    }
    edits.mark("stack_add");
    tooltip("A stack of looks: each one works on the picture of the one before it");
}
}  // namespace

void add_to_stack(const ShelfLook& look, Edits& edits) {
    edits.document([entry = look.entry, name = look.name](Document& document) {
        Stack stack = document.state().stack;
        stack.push_back({entry.id, entry.folder, free_tag(stack, entry.id)});
        document.set_stack(std::move(stack), "Add " + name);
    });
}

void draw_stack_panel(const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document();
    if (!document)
        return;
    heading("Stack");
    const Stack& stack = document->state().stack;
    const bool is_stack = stack.size() > 1 || (!stack.empty() && stack.front().is_bypassed);
    for (std::size_t i = 0; is_stack && i < stack.size(); ++i)
        draw_part(stack, i, scene.shelf, edits);
    draw_add(scene, edits);
    ImGui::Spacing();
}
