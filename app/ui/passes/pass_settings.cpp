#include "ui/passes/pass_settings.h"

#include "lab/commands/look_commands.h"
#include "lab/document/stack_edits.h"
#include "lab/menus/inspector_menu.h"
#include "lab/menus/window_menu.h"
#include "ui/picture/picture_menus.h"
#include "ui/widgets/form.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
void set_override(const std::string& pass, const PassOverride& changed, Edits& edits) {
    edits.change([=](Document& document) { set_override(document, pass, changed); });
}

void draw_scale(const std::string& pass, const PassSetting& now, float width, Edits& edits) {
    std::array<std::string, pass_scales.size()> texts;
    std::array<const char*, pass_scales.size()> labels{};
    int chosen = -1;
    for (std::size_t i = 0; i < pass_scales.size(); ++i) {
        texts[i] = zoom_text(pass_scales[i]);
        labels[i] = texts[i].c_str();
        if (now.scale == pass_scales[i])
            chosen = static_cast<int>(i);
    }
    if (form_list("##scale", labels.data(), static_cast<int>(labels.size()), chosen, width,
                  "Custom")) {
        PassOverride changed = now.tried;
        changed.scale = pass_scales[static_cast<std::size_t>(chosen)];
        set_override(pass, changed, edits);
    }
    tooltip("Size of this pass relative to the render size.");
    edits.mark("pass_scale");
}

void draw_format(const std::string& pass, const PassSetting& now, float width, Edits& edits) {
    if (begin_combo("##format", std::string(info_of(now.format).name), width)) {
        for (const FormatInfo& info : all_formats()) {
            const std::string name(info.name);
            if (ImGui::Selectable(name.c_str(), info.format == now.format)) {
                PassOverride changed = now.tried;
                changed.format = info.format;
                set_override(pass, changed, edits);
            }
            focus_list_item(name, info.format == now.format);
            edits.mark("format:" + name);
        }
        ImGui::EndCombo();
    }
    tooltip("Pixel format of this pass.");
    edits.mark("pass_format");
}

void draw_filter(const std::string& pass, const PassSetting& now, float width, Edits& edits) {
    static constexpr std::array labels{"nearest", "linear"};
    int chosen = now.filter == Filter::linear ? 1 : 0;
    if (form_list("##filter", labels.data(), 2, chosen, width)) {
        PassOverride changed = now.tried;
        changed.filter = chosen == 1 ? Filter::linear : Filter::nearest;
        set_override(pass, changed, edits);
    }
    tooltip("Filter that other passes use to sample this one.");
    edits.mark("pass_filter");
}

bool has_changes(const Scene& scene) {
    return !scene.lab.document->state().overrides.empty();
}

void draw_buttons(Edits& edits) {
    if (ImGui::Button("Save to look.json"))
        edits.change([](LookCommands& looks) { looks.write_overrides(); });
    edits.mark("write_overrides");
    ImGui::SameLine();
    if (quiet_button("Revert"))
        edits.change([](Document& document) { clear_overrides(document); });
    tooltip("Discards the changes made here in all passes.");
}
}  // namespace

float pass_settings_height(const Scene& scene) {
    return (has_changes(scene) ? 2.0f : 1.0f) * ImGui::GetFrameHeightWithSpacing();
}

void draw_pass_settings(const std::string& pass, const Scene& scene, Edits& edits) {
    const auto now = pass_setting(*scene.lab.document, pass);
    if (!now)
        return;
    const float gap = 4.0f;
    const float room = ImGui::GetContentRegionAvail().x - 2.0f * gap;
    draw_scale(pass, *now, std::floor(room * 0.24f), edits);
    ImGui::SameLine(0.0f, gap);
    draw_format(pass, *now, std::floor(room * 0.44f), edits);
    ImGui::SameLine(0.0f, gap);
    draw_filter(pass, *now, std::floor(room * 0.32f), edits);
    if (has_changes(scene))
        draw_buttons(edits);
}
