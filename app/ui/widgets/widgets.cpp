#include "ui/widgets/widgets.h"

#include "base/printable.h"
#include "ui/widgets/line_breaks.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/tooltip_place.h"
#include "ui/widgets/truncated_text.h"
#include "ui/widgets/typed_number.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>

ImTextureID texture_id(std::uintptr_t handle) {
    return reinterpret_cast<ImTextureID>(handle);
}

Pane::Pane(const char* id, const Rect& rect, const ImVec4& background, bool is_padded,
           bool scrolls) {
    ImGui::SetCursorPos({rect.left, rect.top});
    const ScopedColor color(ImGuiCol_ChildBg, background);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding,
                                      is_padded ? ImGui::GetStyle().WindowPadding : ImVec2(0, 0));
    ImGuiWindowFlags flags = ImGuiWindowFlags_NavFlattened;
    if (is_padded)
        flags |= ImGuiWindowFlags_AlwaysUseWindowPadding;
    if (!is_padded || !scrolls)
        flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::BeginChild(id, {std::max(rect.width, 1.0f), std::max(rect.height, 1.0f)}, false, flags);
}

Pane::~Pane() {
    ImGui::EndChild();
}

void dim_text(const std::string& text) {
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    ImGui::TextUnformatted(text.c_str());
}

void wrapped_dim_text(const std::string& text) {
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

std::string wrapped(const std::string& text, float width) {
    return broken_at_blanks(
        text, width, [](const std::string& line) { return ImGui::CalcTextSize(line.c_str()).x; });
}

std::string menu_label(std::string_view name) {
    std::string label = printable(name);
    for (std::size_t at = label.find("##"); at != std::string::npos; at = label.find("##"))
        label.insert(at + 1, 1, ' ');
    return label;
}

std::string elided_to_width(const std::string& text, float width) {
    const auto width_of = [](const std::string& part) {
        return ImGui::CalcTextSize(part.c_str()).x;
    };
    return truncated_to_width(text, width, width_of);
}

namespace {
constexpr std::size_t max_tooltip_bytes = 4096;  // fills the screen
}

void fitted_text(const std::string& text, float width, const ImVec4& color) {
    const std::string cut = elided_to_width(text, width);
    {
        const ScopedColor scoped(ImGuiCol_Text, color);
        ImGui::TextUnformatted(cut.c_str());
    }
    if (cut != text)
        tooltip(shortened(text, max_tooltip_bytes));
}

bool is_hover_delayed() {
    constexpr float delay_seconds = 0.3f;
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !context.IO.MouseDown[0] &&
           (context.HoveredId == 0 || context.HoveredIdTimer > delay_seconds);
}

void tooltip(const std::string& text) {
    if (text.empty() || !is_hover_delayed())
        return;
    const ScopedColor color(ImGuiCol_Text, theme::text);         // independent of the item's colour
    const ScopedFont font(ImGui::GetIO().Fonts->Fonts.front());  // and of its font
    const std::string lines = wrapped(text, ImGui::GetFontSize() * 24.0f);
    begin_tooltip(ImGui::CalcTextSize(lines.c_str()));
    ImGui::TextUnformatted(lines.c_str());
    ImGui::EndTooltip();
}

namespace {
Rect rect_of(const ImRect& rect) {
    return {rect.Min.x, rect.Min.y, rect.GetWidth(), rect.GetHeight()};
}

struct TooltipEnd {
    float y = 0.0f;
    int frame = -2;  // in which it was set
};
TooltipEnd& tooltip_end() {
    static TooltipEnd end;
    return end;
}

// The part of the window that tooltips may cover.
Rect tooltip_area() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const TooltipEnd& end = tooltip_end();
    return {0.0f, 0.0f, display.x,
            ImGui::GetFrameCount() - end.frame <= 1 ? std::min(end.y, display.y) : display.y};
}

// The pane, dialog or menu with the current item.
const ImGuiWindow& pane_of_item() {
    const ImGuiWindow* pane = ImGui::GetCurrentWindow();
    while ((pane->Flags & ImGuiWindowFlags_ChildWindow) != 0 &&
           (pane->ParentWindow->Flags & ImGuiWindowFlags_ChildWindow) != 0)
        pane = pane->ParentWindow;
    return *pane;
}
}  // namespace

void keep_tooltips_above(float y) {
    tooltip_end() = {y, ImGui::GetFrameCount()};
}

void begin_tooltip(const ImVec2& size) {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const ImGuiWindow* previous = ImGui::FindWindowByName("##Tooltip_00");
    ImVec2 inner = size;
    if (size.x == 0.0f && previous)
        inner = previous->DC.CursorMaxPos - previous->DC.CursorStartPos;
    const ImVec2 outer{inner.x + 2.0f * padding.x, inner.y + 2.0f * padding.y};
    const float em = ImGui::GetFontSize();
    const Rect place =
        tooltip_place(rect_of(context.LastItemData.Rect), rect_of(pane_of_item().Rect()),
                      tooltip_area(), {outer.x, outer.y, 0.5f * em, 26.0f * em});
    ImGui::SetNextWindowPos({place.left, place.top});
    ImGui::BeginTooltip();
}

void editor_tooltip(const std::filesystem::path& file) {
    tooltip(fmt::format("{}\nClick to open it in your editor.", file.string()));
}

void heading(const std::string& text) {
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    ImGui::TextUnformatted(text.c_str());
    ImGui::Dummy({0.0f, 1.0f});
}

void heading_with_button(const std::string& text) {
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    ImGui::SameLine(width - ImGui::GetFrameHeight());
}

bool section(const std::string& label, bool opens_first, int buttons) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(label.c_str());
    bool is_open = storage.GetBool(id, opens_first);
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton(
            label.c_str(),
            {ImGui::GetContentRegionAvail().x - static_cast<float>(buttons) * height, height})) {
        is_open = !is_open;
        storage.SetBool(id, is_open);
    }
    const ImVec2 at = ImGui::GetItemRectMin();
    const theme::Color color = ImGui::IsItemHovered() ? theme::accent : theme::text;
    const float middle = at.y + height * 0.5f;
    const float size = ImGui::GetFontSize();
    const float room = ImGui::GetItemRectSize().x - size * 0.95f;
    const std::string shown = elided_to_width(label, room);  // small buttons can follow
    draw_chevron({at.x + size * 0.3f, middle}, is_open,
                 ImGui::IsItemHovered() ? theme::accent : theme::dim);
    ImGui::GetWindowDrawList()->AddText({at.x + size * 0.95f, middle - size * 0.5f},
                                        theme::packed(color), shown.c_str());
    return is_open;
}

void open_section(const std::string& label) {
    ImGui::GetStateStorage()->SetBool(ImGui::GetID(label.c_str()), true);
}

void draw_chevron(const ImVec2& middle, bool is_down, const ImVec4& color) {
    const float size = ImGui::GetFontSize() * 0.2f;
    const float flat = size * 0.55f;
    const std::array<ImVec2, 3> points = is_down
                                             ? std::array{ImVec2(middle.x - size, middle.y - flat),
                                                          ImVec2(middle.x, middle.y + flat),
                                                          ImVec2(middle.x + size, middle.y - flat)}
                                             : std::array{ImVec2(middle.x - flat, middle.y - size),
                                                          ImVec2(middle.x + flat, middle.y),
                                                          ImVec2(middle.x - flat, middle.y + size)};
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), 3, ImGui::GetColorU32(color), 0,
                                            ImGui::GetFontSize() * 0.1f);
}

void focus_list_item(std::string_view label, bool is_chosen) {
    if (is_chosen)
        ImGui::SetItemDefaultFocus();
    if (typing().list_item.is_found(label))
        ImGui::SetKeyboardFocusHere(-1);
}

bool begin_combo(const char* id, const std::string& current, float width) {
    ImGui::SetNextItemWidth(width);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const std::string cut = elided_to_width(current, width - ImGui::GetFontSize() * 1.6f);
    const bool is_open = ImGui::BeginCombo(
        id, cut.c_str(), ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLarge);
    if (is_open) {
        std::string letters;
        for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters)
            if (letter < 0x80)
                letters += static_cast<char>(letter);
        typing().list_item.add(letters, ImGui::GetTime());
        return true;  // now the list is drawn
    }
    draw_chevron(
        {low.x + width - ImGui::GetFontSize() * 0.7f, low.y + ImGui::GetFrameHeight() * 0.5f}, true,
        theme::dim);
    return false;
}

bool quiet_button(const std::string& label) {
    const ScopedColor back(ImGuiCol_Button, theme::none);
    const ScopedStyle<float> border(ImGuiStyleVar_FrameBorderSize, 0.0f);
    return ImGui::Button(label.c_str());
}

int choice(const char* id, const char* const* labels, int count, int chosen, Edits& edits) {
    const ScopedId scope{std::string(id)};
    const ScopedStyle<ImVec2> gap(ImGuiStyleVar_ItemSpacing,
                                  ImVec2(2.0f, ImGui::GetStyle().ItemSpacing.y));
    for (int i = 0; i < count; ++i) {
        if (i > 0)
            ImGui::SameLine();
        const bool is_chosen = i == chosen;
        const ScopedColor text(ImGuiCol_Text, is_chosen ? theme::accent : theme::dim);
        const ScopedColor back(ImGuiCol_Button, is_chosen ? theme::field : theme::none);
        if (ImGui::Button(labels[i]))
            chosen = i;
        edits.mark(std::string(id) + ':' + labels[i]);
    }
    return chosen;
}

void same_line_right(float width) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
}

std::string size_text(Extent extent) {
    return fmt::format("{} × {}", extent.width, extent.height);
}
