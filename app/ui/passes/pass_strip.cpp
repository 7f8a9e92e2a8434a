#include "ui/passes/pass_strip.h"

#include "lab/frame/heavy_pass.h"
#include "ui/passes/pass_edit_items.h"
#include "ui/passes/strip_blocks.h"
#include "ui/passes/strip_cell.h"
#include "ui/passes/strip_text.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr float text_lines = 3.7f;  // below the picture: name, facts, gain

// In a stack, the key of the look is shown above its passes.
std::string look_key(const std::string& pass) {
    const std::size_t end = pass.find('/');
    return end == std::string::npos ? std::string() : pass.substr(0, end);
}

// The switch state, over the picture.
void draw_state(const std::string& state, const Scene& scene, const ImVec2& low, float width) {
    const ScopedFont font(scene.fonts.numbers);
    const ImVec2 pad(4.0f * scene.scale, 1.0f * scene.scale);
    const std::string text = elided_to_width(state, width - 2.0f * pad.x);
    const ImVec2 text_size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 right(low.x + width, low.y + text_size.y + 2.0f * pad.y);
    const ImVec2 left(right.x - text_size.x - 2.0f * pad.x, low.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(left, right, theme::packed(theme::popup), 3.0f * scene.scale);
    list.AddText({left.x + pad.x, left.y + pad.y}, theme::packed(theme::warning), text.c_str());
}

ImU32 color_of_time(const StripText& strip) {
    return theme::packed(strip.longest > heavy_pass_milliseconds ? theme::problem : theme::dim);
}

// Draws the time to the left of `right`; returns its width.
float draw_time(const StripText& strip, const ImVec2& right, const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    const std::string time = strip_text::time(strip.milliseconds);
    const float width = ImGui::CalcTextSize(time.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({right.x - width, right.y}, color_of_time(strip),
                                        time.c_str());
    return width;
}

void draw_text(const StripText& strip, bool is_narrow, const Scene& scene, const ImVec2& at,
               float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetFontSize();
    const std::string time = strip_text::time(strip.milliseconds);
    float room = width;
    if (!is_narrow && !time.empty())
        room -= draw_time(strip, {at.x + width, at.y + 1.0f}, scene) + line * 0.6f;
    const std::string name = elided_to(strip.name, room, [](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str()).x;
    });
    list.AddText(at, theme::packed(strip.is_chosen ? theme::accent : theme::text), name.c_str());
    const ScopedFont font(scene.fonts.numbers);
    const std::string info = elided_to_width(is_narrow ? time : strip.info, width);
    list.AddText({at.x, at.y + line * 1.2f},
                 is_narrow ? color_of_time(strip) : theme::packed(theme::dim), info.c_str());
    if (strip.change) {
        const std::string change =
            elided_to_width(strip_text::change(*strip.change, is_narrow), width);
        const theme::Color color = strip.change->has_changed() ? theme::accent : theme::dim;
        list.AddText({at.x, at.y + line * 2.4f}, theme::packed(color), change.c_str());
        return;
    }
    if (!strip.gain)
        return;
    const std::string all = strip_text::gain(*strip.gain, false);
    const bool is_cut = is_narrow || ImGui::CalcTextSize(all.c_str()).x > width;
    const std::string gain =
        is_cut ? elided_to_width(strip_text::gain(*strip.gain, true), width) : all;
    const bool is_clipped = strip_text::is_clipped(*strip.gain);
    list.AddText({at.x, at.y + line * 2.4f},
                 theme::packed(is_clipped ? theme::warning : theme::dim), gain.c_str());
}

// Each level of a pyramid shows its part of the picture. Together they form one picture with
// changing resolution. In a wider strip the parts overlap.
void draw_block(const StripBlock& block, const Scene& scene, float image_height, Edits& edits) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = block.width_of_one();
    const float text_height = ImGui::GetFontSize() * text_lines;
    const float seam = block.is_pass() ? 0.0f : scene.scale;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < block.passes.size(); ++i) {
        if (i > 0)
            ImGui::SameLine(0.0f, seam);
        const float last = static_cast<float>(block.passes.size()) - 1.0f;
        const float part = block.is_pass() ? 0.5f : static_cast<float>(i) / last;
        const Rect cell{low.x + width * static_cast<float>(i), low.y, width - seam, image_height};
        draw_strip_cell(block.passes[i], scene, cell, text_height, part, edits);
    }
    ImGui::EndGroup();
    if (!block.state.empty())
        draw_state(block.state, scene, low, block.width);
    draw_text(block.text, block.is_narrow, scene,
              {low.x, low.y + image_height + 3.0f * scene.scale}, block.width);
}

/// The passes of one look of a stack and their extent in the strip.
struct Group {
    std::string key;
    float left;
    float right;
};

// A tag that stays visible while any pass of its look is visible.
void draw_key(const Group& group, float top, const Scene& scene) {
    const ScopedFont font(scene.fonts.numbers);
    const ImVec2 text_size = ImGui::CalcTextSize(group.key.c_str());
    const ImVec2 pad(5.0f * scene.scale, 2.0f * scene.scale);
    const float width = text_size.x + 2.0f * pad.x;
    const float visible_left = std::max(group.left, ImGui::GetWindowPos().x);
    const float left = std::max(group.left, std::min(visible_left, group.right - width));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left, top}, {left + width, top + text_size.y + 2.0f * pad.y},
                       theme::packed(theme::popup), 3.0f * scene.scale);
    list.AddText({left + pad.x, top + pad.y}, theme::packed(theme::label), group.key.c_str());
}

float add_button_width() {
    return std::floor(ImGui::GetFontSize() * 1.8f);
}

// Sets the position of the next block, closer to a block of the same look.
void continue_row(const std::vector<Group>& groups, const std::string& key, const Scene& scene) {
    const float gap = strip_gap();
    const bool is_other = groups.back().key != key;
    ImGui::SameLine(0.0f, is_other ? 2.5f * gap : gap);
    if (!is_other)
        return;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float x = std::floor(low.x - 1.25f * gap);
    const float bottom = ImGui::GetWindowPos().y + ImGui::GetContentRegionAvail().y;
    ImGui::GetWindowDrawList()->AddLine({x, low.y}, {x, bottom}, theme::packed(theme::line),
                                        scene.scale);
}

// Scrolls to the block that was just drawn if one of its passes has just been inspected. The
// previously inspected pass must be in the same look.
void follow_chosen(const StripBlock& block, const Scene& scene, Edits& edits) {
    const std::string& chosen = scene.window.views.inspected.pass;
    const std::string& previous = scene.window.scrolled.pass;
    if (chosen == previous || std::ranges::none_of(block.passes, &StripPass::is_chosen))
        return;
    edits.arrange([chosen](WindowState& window) { window.scrolled.pass = chosen; });
    if (!find_pass(scene.lab.renderer->executor().look(), previous))
        return;
    const float left = ImGui::GetWindowPos().x;
    const float right = left + ImGui::GetWindowWidth();
    const float low = ImGui::GetItemRectMin().x;
    const float hidden =
        low < left ? low - left : std::max(ImGui::GetItemRectMax().x - right, 0.0f);
    if (hidden != 0.0f)
        ImGui::SetScrollX(ImGui::GetScrollX() + hidden);
}

void draw_blocks(const std::vector<StripBlock>& blocks, float image_height, const Scene& scene,
                 Edits& edits) {
    const float top = ImGui::GetCursorScreenPos().y;
    std::vector<Group> groups;
    for (const StripBlock& block : blocks) {
        const std::string key = look_key(block.passes.front().pass.name);
        if (!groups.empty())
            continue_row(groups, key, scene);
        if (groups.empty() || groups.back().key != key)
            groups.push_back({key, ImGui::GetCursorScreenPos().x, 0.0f});
        draw_block(block, scene, image_height, edits);
        follow_chosen(block, scene, edits);
        groups.back().right = ImGui::GetItemRectMax().x;
    }
    for (const Group& group : groups)
        if (!group.key.empty())
            draw_key(group, top, scene);
}
// A cell with a plus sign after the last pass.
void draw_add_button(float image_height, const Scene& scene, Edits& edits) {
    ImGui::SameLine(0.0f, strip_gap());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size(add_button_width(), image_height);
    if (ImGui::InvisibleButton("##add_pass", size))
        ask_for_pass(scene.lab.renderer->executor().look().passes.back().name, scene, edits);
    edits.mark("add_pass");
    const bool is_hovered = ImGui::IsItemHovered();
    tooltip("Add a pass after the last one");
    const ImU32 color = theme::packed(is_hovered ? theme::text : theme::dim);
    const ImVec2 high(low.x + size.x, low.y + size.y);
    const ImVec2 middle(std::floor(0.5f * (low.x + high.x)), std::floor(0.5f * (low.y + high.y)));
    const float arm = ImGui::GetFontSize() * 0.4f;
    const float thick = 1.5f * scene.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect(low, high, theme::packed(is_hovered ? theme::label : theme::line), 0.0f, 0,
                 scene.scale);
    list.AddLine({middle.x - arm, middle.y}, {middle.x + arm, middle.y}, color, thick);
    list.AddLine({middle.x, middle.y - arm}, {middle.x, middle.y + arm}, color, thick);
}
}  // namespace

void draw_pass_strip(const Scene& scene, Edits& edits) {
    if (!scene.lab.renderer)
        return;
    const float scrollbar = ImGui::GetStyle().ScrollbarSize;
    const float room =
        ImGui::GetContentRegionAvail().y - ImGui::GetFontSize() * text_lines - scrollbar;
    const float image_height = std::max(24.0f, std::floor(room));
    const int wanted = static_cast<int>(image_height * scene.density);
    if (wanted != scene.window.views.sizes.thumbnail_height)
        edits.arrange(
            [wanted](WindowState& window) { window.views.sizes.thumbnail_height = wanted; });
    {  // only for the strip: popups above it keep their own padding
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##cells", {0.0f, 0.0f}, false,
                          ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NavFlattened);
    }
    const std::vector<StripPass> passes = present_passes(scene);
    const float width = ImGui::GetContentRegionAvail().x - add_button_width() - strip_gap();
    draw_blocks(arrange_strip(passes, width, scene), image_height, scene, edits);
    draw_add_button(image_height, scene, edits);
    // The strip cannot scroll vertically, so the wheel scrolls it horizontally.
    constexpr float a_notch = 5.0f;  // in font sizes
    if (const float wheel = ImGui::GetIO().MouseWheel; wheel != 0.0f && ImGui::IsWindowHovered())
        ImGui::SetScrollX(ImGui::GetScrollX() - wheel * a_notch * ImGui::GetFontSize());
    ImGui::EndChild();
}
