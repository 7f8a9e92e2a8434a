#include "ui/window/toolkit.h"

#include "ui/widgets/theme.h"

#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iterator>
#include <limits>

Toolkit::Toolkit(gpu::Window& window, BuiltFonts fonts)
    : m_window(window), m_fonts(std::move(fonts)) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext(m_fonts.atlas.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // the session stores the layout
    io.LogFilename = nullptr;
    io.UserData = &m_typing;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.ConfigInputTextCursorBlink = false;  // an idle window draws nothing
    ImGui_ImplGlfw_InitForOpenGL(static_cast<GLFWwindow*>(window.native()), false);
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
    const bool is_first = !is_ready();
    m_scale = scale;
    m_density = density;
    ImGui::GetStyle() = theme::style();
    ImGui::GetStyle().ScaleAllSizes(scale);
    if (m_fonts.scale != scale * density) {
        BuiltFonts other = build_fonts(scale * density);
        ImGui::GetIO().Fonts = other.atlas.get();
        m_fonts = std::move(other);
    }
    ImGui::GetIO().FontGlobalScale = 1.0f / density;
    if (is_first)
        return;  // the backend uploads them with its first frame
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

namespace {
constexpr float nowhere = -std::numeric_limits<float>::max();

void apply(const gpu::KeyEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    if (event.key < 0 || event.key >= IM_ARRAYSIZE(io.KeysDown))
        return;
    io.KeysDown[event.key] = event.is_down;
    const auto is_down = [&io](int offset) {
        return io.KeysDown[gpu::key::left_shift + offset] ||
               io.KeysDown[gpu::key::right_shift + offset];
    };
    io.KeyShift = is_down(0);
    io.KeyCtrl = is_down(1);
    io.KeyAlt = is_down(2);
    io.KeySuper = is_down(3);
}

void apply(const gpu::TextEvent& event) {
    ImGui::GetIO().AddInputCharacter(event.code_point);
}

void apply(const gpu::ButtonEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    if (event.button >= 0 && event.button < IM_ARRAYSIZE(io.MouseDown))
        io.MouseDown[event.button] = event.is_down;
}

void apply(const gpu::PointerEvent& event) {
    ImGui::GetIO().MousePos = {event.x, event.y};
}

void apply(const gpu::PointerLeftEvent&) {
    ImGuiIO& io = ImGui::GetIO();
    if (std::none_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool is) { return is; }))
        io.MousePos = {nowhere, nowhere};
}

void apply(const gpu::WheelEvent& event) {
    ImGui::GetIO().MouseWheel += event.y;
    ImGui::GetIO().MouseWheelH += event.x;
}
}  // namespace

// The backend also polls the mouse. Its state can be newer than the events of this frame.
void Toolkit::take_input() {
    ImGuiIO& io = ImGui::GetIO();
    const ImVec2 position = io.MousePos;
    std::array<bool, IM_ARRAYSIZE(io.MouseDown)> buttons{};
    std::copy(std::begin(io.MouseDown), std::end(io.MouseDown), buttons.begin());
    ImGui_ImplGlfw_NewFrame();
    io.MousePos = position;
    std::copy(buttons.begin(), buttons.end(), std::begin(io.MouseDown));
    m_input.add(m_window.events().take_input());
    m_pointer_path.clear();
    const std::vector<gpu::InputEvent> events = m_input.take_frame(io.WantTextInput);
    m_has_input = !events.empty();
    for (const gpu::InputEvent& event : events) {
        std::visit([](const auto& one) { apply(one); }, event);
        if (const auto* moved = std::get_if<gpu::PointerEvent>(&event))
            m_pointer_path.push_back(*moved);
    }
}

namespace {
double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
}  // namespace

void Toolkit::make_ready(float scale) {
    // If the desktop scales windows, one window coordinate covers several pixels.
    const Extent size = m_window.size();
    const Extent pixels = m_window.framebuffer_size();
    const float density = size.is_empty() || pixels.is_empty()
                              ? 1.0f
                              : static_cast<float>(pixels.width) / static_cast<float>(size.width);
    const float wanted = scale * m_window.content_scale() / density;
    set_scale(fitted_scale(wanted), density);
    ImGui_ImplOpenGL3_NewFrame();
}

void Toolkit::draw_first() {
    const Extent pixels = m_window.framebuffer_size();
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRect({0.0f, 0.0f}, {1.0f, 1.0f});
    list.AddRectFilled({0.0f, 0.0f}, {1.0f, 1.0f}, IM_COL32_BLACK);
    ImDrawList* lists = &list;
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = &lists;
    data.CmdListsCount = 1;
    data.TotalIdxCount = list.IdxBuffer.Size;
    data.TotalVtxCount = list.VtxBuffer.Size;
    data.DisplaySize = {static_cast<float>(pixels.width), static_cast<float>(pixels.height)};
    data.FramebufferScale = {1.0f, 1.0f};
    ImGui_ImplOpenGL3_RenderDrawData(&data);
}

bool Toolkit::awaits_tooltip() const {
    constexpr float due_seconds = 0.4f;  // a little later than is_hover_delayed()
    const ImGuiContext* context = ImGui::GetCurrentContext();
    return context && context->HoveredId != 0 && context->HoveredIdTimer < due_seconds;
}

void Toolkit::begin(float scale) {
    m_begin_seconds = cpu_seconds();
    make_ready(scale);
    take_input();
    // Each frame takes one press or release. At low frame rates, both clicks need more time.
    constexpr float double_click_seconds = 0.3f;
    constexpr float double_click_frames = 5.0f;
    ImGuiIO& io = ImGui::GetIO();
    io.MouseDoubleClickTime = std::max(double_click_seconds, double_click_frames * io.DeltaTime);
    ImGui::NewFrame();
}

void Toolkit::end() {
    ImGui::Render();
    m_panel_milliseconds = 1e3 * (cpu_seconds() - m_begin_seconds);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}
