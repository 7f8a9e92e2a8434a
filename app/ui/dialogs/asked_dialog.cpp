#include "ui/dialogs/asked_dialog.h"

#include "lab/choices/lab_choices.h"
#include "lab/choices/palette.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/widgets/choice_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

namespace {
// nullopt: the choice no longer exists.
std::optional<Choice> asking(const Scene& scene) {
    const std::string& label = scene.window.dialog.subject;
    for (const ChoiceList& list : all_choices(scene.lab, scene.window, scene.library_view.looks()))
        for (const Choice& choice : list.choices)
            if (list.label_of(choice) == label)
                return choice;
    return std::nullopt;
}

NumberFacts facts_of(const AskedNumber& asked) {
    return {.unit = asked.unit, .limit = asked.limit, .is_whole = asked.is_whole};
}

std::string words_about(const AskedNumber& asked) {
    constexpr double practically_none = 1e6;
    if (asked.limit.high - asked.limit.low >= practically_none)
        return asked.unit.empty() ? "Any number" : fmt::format("Any number, in {}", asked.unit);
    const std::string low = short_number(asked.limit.low);
    const std::string high = short_number(asked.limit.high);
    return asked.unit.empty() ? fmt::format("{} to {}", low, high)
                              : fmt::format("{} to {} {}", low, high, asked.unit);
}

// The typed text, including the input of this frame.
std::string draw_answer(const Choice& choice, const Dialog& dialog, Edits& edits) {
    std::string text = dialog.text;
    if (dialog.is_new) {
        text = choice.number ? fmt::format("{:.7g}", choice.number->present) : choice.text->present;
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputText("##asked", &text, ImGuiInputTextFlags_AutoSelectAll);
    edits.mark("asked");
    edits.arrange([text](WindowState& window) {
        window.dialog.text = text;
        window.dialog.is_new = false;
    });
    return text;
}

void answer(const Choice& choice, const std::string& text, Edits& edits) {
    if (choice.text)
        return run(choice.text->answer(text), edits);
    TypedNumber typed = read_typed_number(text, facts_of(*choice.number));
    if (typed.value)
        run(choice.number->answer(*typed.value), edits);
    if (!typed.complaint.empty())
        edits.add(
            [words = std::move(typed.complaint)](Lab& lab) { lab.messages().say(words, true); });
}
}  // namespace

void draw_asked_dialog(const Scene& scene, Edits& edits) {
    const std::optional<Choice> choice = asking(scene);
    if (!choice || (!choice->number && !choice->text))
        return close_dialog(edits);
    const DialogFrame frame(scene.window.dialog.subject.c_str(), 26.0f, scene, edits);
    if (!frame.is_open())
        return;
    if (choice->number) {
        if (!choice->number->help.empty())
            wrapped_dim_text(choice->number->help);
        dim_text(words_about(*choice->number));
    }
    const std::string text = draw_answer(*choice, scene.window.dialog, edits);
    if (!draw_dialog_buttons("Apply", true, edits))
        return;
    close_dialog(edits);
    answer(*choice, text, edits);
}
