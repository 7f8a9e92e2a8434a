#include "ui/widgets/theme.h"

namespace {
void set_sizes(ImGuiStyle& style) {
    style.WindowPadding = {10.0f, 8.0f};
    style.FramePadding = {7.0f, 3.0f};
    style.ItemSpacing = {7.0f, 5.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    style.CellPadding = {4.0f, 3.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 10.0f;
    style.GrabMinSize = 8.0f;
    style.WindowBorderSize = 0.0f;
    style.ChildBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.FrameBorderSize = 1.0f;
    style.WindowRounding = 0.0f;
    style.ChildRounding = 0.0f;
    style.PopupRounding = 5.0f;
    style.FrameRounding = 3.0f;
    style.ScrollbarRounding = 5.0f;
    style.GrabRounding = 3.0f;
    style.TabRounding = 3.0f;
}

void set_surfaces(ImVec4* colors) {
    colors[ImGuiCol_Text] = theme::text;
    colors[ImGuiCol_TextDisabled] = theme::dim;
    colors[ImGuiCol_WindowBg] = theme::pane;
    colors[ImGuiCol_ChildBg] = theme::none;
    colors[ImGuiCol_PopupBg] = theme::popup;
    colors[ImGuiCol_Border] = theme::outline;
    colors[ImGuiCol_BorderShadow] = theme::none;
    colors[ImGuiCol_MenuBarBg] = theme::pane;
    colors[ImGuiCol_ScrollbarBg] = theme::none;
    colors[ImGuiCol_ScrollbarGrab] = theme::field_active;
    colors[ImGuiCol_ScrollbarGrabHovered] = theme::filled;
    colors[ImGuiCol_ScrollbarGrabActive] = theme::faint;
    colors[ImGuiCol_TitleBg] = theme::pane;
    colors[ImGuiCol_TitleBgActive] = theme::pane;
    colors[ImGuiCol_TitleBgCollapsed] = theme::pane;
    colors[ImGuiCol_Separator] = theme::line;
    colors[ImGuiCol_SeparatorHovered] = theme::accent_filled;
    colors[ImGuiCol_SeparatorActive] = theme::accent;
    colors[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.5f};
    colors[ImGuiCol_TableBorderLight] = theme::line;
    colors[ImGuiCol_TableBorderStrong] = theme::line;
    colors[ImGuiCol_TableHeaderBg] = theme::pane;
}

void set_controls(ImVec4* colors) {
    colors[ImGuiCol_FrameBg] = theme::field;
    colors[ImGuiCol_FrameBgHovered] = theme::field_hovered;
    colors[ImGuiCol_FrameBgActive] = theme::field_active;
    colors[ImGuiCol_CheckMark] = theme::accent;
    colors[ImGuiCol_SliderGrab] = theme::faint;
    colors[ImGuiCol_SliderGrabActive] = theme::accent;
    colors[ImGuiCol_Button] = theme::field;
    colors[ImGuiCol_ButtonHovered] = theme::field_active;
    colors[ImGuiCol_ButtonActive] = theme::filled;
    colors[ImGuiCol_Header] = theme::field;
    colors[ImGuiCol_HeaderHovered] = theme::field_hovered;
    colors[ImGuiCol_HeaderActive] = theme::field_active;
    colors[ImGuiCol_Tab] = theme::none;
    colors[ImGuiCol_TabHovered] = theme::field_hovered;
    colors[ImGuiCol_TabActive] = theme::field;
    colors[ImGuiCol_PlotLines] = theme::dim;
    colors[ImGuiCol_PlotLinesHovered] = theme::accent;
    colors[ImGuiCol_PlotHistogram] = theme::filled;
    colors[ImGuiCol_TextSelectedBg] = theme::accent_filled;
    colors[ImGuiCol_DragDropTarget] = theme::accent;
    colors[ImGuiCol_NavHighlight] = theme::accent_filled;
}
}  // namespace

ImGuiStyle theme::style() {
    ImGuiStyle style;
    set_sizes(style);
    set_surfaces(style.Colors);
    set_controls(style.Colors);
    return style;
}
