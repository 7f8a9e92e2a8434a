#include "ui/dialogs/prompt_dialog.h"

#include "lab/menus/menu_sections.h"
#include "lab/menus/palette.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

namespace {
// nullopt: the entry no longer exists.
std::optional<MenuEntry> asking(const Scene& scene) {
    const std::string& label = scene.window.dialog.subject;
    for (const MenuSection& section :
         menu_sections(scene.lab, scene.window, scene.library_view.looks()))
        for (const MenuEntry& entry : section.entries)
            if (section.label_of(entry) == label)
                return entry;
    return std::nullopt;
}

NumberInfo info_of(const NumberPrompt& asked) {
    return {.unit = asked.unit, .limit = asked.limit, .is_whole = asked.is_whole};
}

std::string help_about(const NumberPrompt& asked) {
    constexpr double practically_none = 1e6;
    if (asked.limit.high - asked.limit.low >= practically_none)
        return asked.unit.empty() ? "Any number" : fmt::format("Any number, in {}", asked.unit);
    const std::string low = short_number(asked.limit.low);
    const std::string high = short_number(asked.limit.high);
    return asked.unit.empty() ? fmt::format("{} to {}", low, high)
                              : fmt::format("{} to {} {}", low, high, asked.unit);
}

// The typed text, including the input of this frame.
std::string draw_answer(const MenuEntry& entry, const Dialog& dialog, Edits& edits) {
    std::string text = dialog.text;
    if (dialog.is_new) {
        text = entry.number ? fmt::format("{:.7g}", entry.number->current) : entry.text->current;
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputText("##asked", &text, ImGuiInputTextFlags_AutoSelectAll);
    edits.mark("asked");
    edits.arrange([text](WindowState& window) {
        if (window.dialog.text != text)
            window.dialog.problem.clear();
        window.dialog.text = text;
        window.dialog.is_new = false;
    });
    return text;
}

// Why the typed text is not a number; "": it is one.
std::string complaint_about(const MenuEntry& entry, const std::string& text) {
    if (!entry.number || text.empty())
        return {};
    const TypedNumber typed = read_typed_number(text, info_of(*entry.number));
    return typed.value ? std::string() : typed.complaint;
}

void answer(const MenuEntry& entry, const std::string& text, Edits& edits) {
    begin_attempt(edits);
    if (entry.text)
        run(entry.text->answer(text), edits);
    TypedNumber typed =
        entry.number ? read_typed_number(text, info_of(*entry.number)) : TypedNumber();
    if (typed.value)
        run(entry.number->answer(*typed.value), edits);
    end_attempt(edits);
    if (typed.value && !typed.complaint.empty())  // it was limited
        edits.change([complaint = std::move(typed.complaint)](Messages& messages) {
            messages.say(complaint, true);
        });
}
}  // namespace

void draw_asked_dialog(const Scene& scene, Edits& edits) {
    const std::optional<MenuEntry> entry = asking(scene);
    if (!entry || (!entry->number && !entry->text))
        return close_dialog(edits);
    const DialogFrame frame(scene.window.dialog.subject.c_str(), 26.0f, scene, edits);
    if (!frame.is_open())
        return;
    if (entry->number) {
        if (!entry->number->help.empty())
            wrapped_dim_text(entry->number->help);
        dim_text(help_about(*entry->number));
    }
    const std::string text = draw_answer(*entry, scene.window.dialog, edits);
    const std::string complaint = complaint_about(*entry, text);
    draw_dialog_problem(complaint.empty() ? scene.window.dialog.problem : complaint, edits);
    const bool can_apply = complaint.empty() && !(entry->number && text.empty());
    if (draw_dialog_buttons("Apply", can_apply, edits))
        answer(*entry, text, edits);
}
