#include "ui/toolkit.h"

#include "ui/theme.h"

#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>

Toolkit::Toolkit(gpu::Window& window) : m_window(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // the session keeps the window's arrangement
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.ConfigInputTextCursorBlink = false;  // a resting window draws nothing
    ImGui_ImplGlfw_InitForOpenGL(static_cast<GLFWwindow*>(window.native()), true);
    ImGui_ImplOpenGL3_Init("#version 410 core");
}

Toolkit::~Toolkit() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Toolkit::set_scale(float scale, float density) {
    if (scale == m_scale && density == m_density)
        return;
    m_scale = scale;
    m_density = density;
    ImGui::GetStyle() = theme::style();
    ImGui::GetStyle().ScaleAllSizes(scale);
    m_fonts = load_fonts(scale * density);
    ImGui::GetIO().FontGlobalScale = 1.0f / density;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Toolkit::begin(float scale) {
    // Where the desktop scales windows itself, a coordinate of the window covers several pixels.
    const Extent size = m_window.size();
    const Extent pixels = m_window.framebuffer_size();
    const float density = size.is_empty() || pixels.is_empty()
                              ? 1.0f
                              : static_cast<float>(pixels.width) / static_cast<float>(size.width);
    const float wanted = scale * m_window.content_scale() / density;
    set_scale(std::clamp(std::round(wanted * 8.0f) / 8.0f, 0.5f, 4.0f), density);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Toolkit::end() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}
