#pragma once

#include <imgui/imgui.h>

#include <string>

/// Scope guards for ImGui's push and pop functions.
class ScopedId {
public:
    explicit ScopedId(const std::string& id) { ImGui::PushID(id.c_str()); }
    explicit ScopedId(int id) { ImGui::PushID(id); }
    ~ScopedId() { ImGui::PopID(); }
    ScopedId(const ScopedId&) = delete;
    ScopedId& operator=(const ScopedId&) = delete;
};

class ScopedFont {
public:
    explicit ScopedFont(ImFont* font) { ImGui::PushFont(font); }
    ~ScopedFont() { ImGui::PopFont(); }
    ScopedFont(const ScopedFont&) = delete;
    ScopedFont& operator=(const ScopedFont&) = delete;
};

class ScopedColor {
public:
    ScopedColor(ImGuiCol which, const ImVec4& color) { ImGui::PushStyleColor(which, color); }
    ~ScopedColor() { ImGui::PopStyleColor(); }
    ScopedColor(const ScopedColor&) = delete;
    ScopedColor& operator=(const ScopedColor&) = delete;
};

template <class T>
class ScopedStyle {
public:
    ScopedStyle(ImGuiStyleVar which, const T& value) { ImGui::PushStyleVar(which, value); }
    ~ScopedStyle() { ImGui::PopStyleVar(); }
    ScopedStyle(const ScopedStyle&) = delete;
    ScopedStyle& operator=(const ScopedStyle&) = delete;
};

class ScopedDisabled {
public:
    explicit ScopedDisabled(bool is_disabled) { ImGui::BeginDisabled(is_disabled); }
    ~ScopedDisabled() { ImGui::EndDisabled(); }
    ScopedDisabled(const ScopedDisabled&) = delete;
    ScopedDisabled& operator=(const ScopedDisabled&) = delete;
};
