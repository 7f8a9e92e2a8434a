#include "ui/picture/slot_buttons.h"

#include "ui/frame/action.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>

namespace {
struct SlotActions {
    ActionId keep;
    ActionId recall;
    ActionId compare;
};
constexpr std::array<SlotActions, 3> button_actions{
    {{ActionId::store_a, ActionId::recall_a, ActionId::with_a},
     {ActionId::store_b, ActionId::recall_b, ActionId::with_b},
     {ActionId::store_c, ActionId::recall_c, ActionId::with_c}}};

std::string content_of(const Slot& slot, const std::string& name, bool is_current) {
    if (slot.preset.empty())
        return is_current ? fmt::format("Slot {} holds the current settings.", name)
                          : fmt::format("Slot {} holds stored settings.", name);
    return is_current
               ? fmt::format("Slot {} holds the current settings of \"{}\".", name, slot.preset)
               : fmt::format("Slot {} holds settings of \"{}\".", name, slot.preset);
}

std::string help_for(std::size_t number, const Scene& scene) {
    const std::optional<Slot>& slot = scene.lab.frames.comparison().slots()[number];
    const std::string name = slot_name(number);
    if (!slot)
        return fmt::format("Slot {} is empty. Click to store the current settings (Shift+F{}).",
                           name, 5 + number);
    return fmt::format(
        "{}\nClick to recall it (F{}). Shift+click to store the current settings in it. Ctrl+click "
        "to compare with it. Right-click for all commands.",
        content_of(*slot, name, scene.lab.frames.comparison().is_in_slot(number)), 5 + number);
}

void draw_menu_items(std::size_t number, const Scene& scene, Edits& edits) {
    const ScopedFont font(scene.fonts.text);
    const SlotActions& of = button_actions[number];
    const bool is_filled = scene.lab.frames.comparison().slots()[number].has_value();
    const std::string name = "slot:" + slot_name(number);
    for (const ActionId id : {of.keep, of.recall, of.compare}) {
        if (ImGui::MenuItem(scene.actions.help(id).c_str(), nullptr, false,
                            is_filled || id == of.keep))
            run(id, scene, edits);
        edits.mark(name + (id == of.keep ? ":keep" : id == of.recall ? ":recall" : ":compare"));
    }
    if (ImGui::MenuItem(fmt::format("Clear slot {}", slot_name(number)).c_str(), nullptr, false,
                        is_filled))
        edits.change([number](ComparisonView& comparison) { comparison.clear_slot(number); });
    edits.mark(name + ":empty");
}

void draw_menu(std::size_t number, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginPopupContextItem())
        return;
    draw_menu_items(number, scene, edits);
    ImGui::EndPopup();
}

void click(std::size_t number, const Scene& scene, Edits& edits) {
    const ImGuiIO& io = ImGui::GetIO();
    const SlotActions& of = button_actions[number];
    if (io.KeyShift || !scene.lab.frames.comparison().slots()[number])
        run(of.keep, scene, edits);
    else
        run(io.KeyCtrl ? of.compare : of.recall, scene, edits);
}

void draw_slot(std::size_t number, const Scene& scene, Edits& edits) {
    const std::string name = slot_name(number);
    const Comparison& comparison = scene.lab.frames.comparison().selection().chosen();
    const bool is_other =
        comparison.mode != CompareMode::off && comparison.other == Other{Other::Kind::slot, number};
    const bool is_filled = scene.lab.frames.comparison().slots()[number].has_value();
    const bool is_here = scene.lab.frames.comparison().is_in_slot(number);
    const float side = ImGui::GetFrameHeight();
    {
        const ScopedColor text(ImGuiCol_Text, is_here     ? theme::accent
                                              : is_filled ? theme::text
                                                          : theme::dim);
        const ScopedColor back(ImGuiCol_Button, is_filled ? theme::field : theme::none);
        if (ImGui::Button((name + "##slot").c_str(), {side, side}))
            click(number, scene, edits);
    }
    edits.mark("slot:" + name);
    if (is_other) {
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 high = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRectFilled({low.x + 3.0f, high.y - 2.0f * scene.scale},
                                                  {high.x - 3.0f, high.y},
                                                  theme::packed(theme::text));
    }
    tooltip(help_for(number, scene));
    draw_menu(number, scene, edits);
}
}  // namespace

float slot_buttons_width() {
    return 3.0f * ImGui::GetFrameHeight() + 2.0f * 2.0f;
}

void draw_slot_buttons(const Scene& scene, Edits& edits) {
    const ScopedDisabled off(!scene.lab.document);
    for (std::size_t number = 0; number < button_actions.size(); ++number) {
        if (number > 0)
            ImGui::SameLine(0.0f, 2.0f);
        draw_slot(number, scene, edits);
    }
}
