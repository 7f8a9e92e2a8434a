#pragma once

#include "gpu/window.h"
#include "ui/frame/fonts.h"
#include "ui/widgets/typed_number.h"
#include "ui/window/input_queue.h"

#include <string>
#include <utility>
#include <vector>

/// ImGui in a window: its context, its fonts and the two backends. One at a time.
class Toolkit {
public:
    /// `fonts` serve where their scale is the display's; else they are built anew.
    Toolkit(gpu::Window& window, BuiltFonts fonts);
    ~Toolkit();
    Toolkit(const Toolkit&) = delete;
    Toolkit& operator=(const Toolkit&) = delete;

    /// Whether the person did more than the last frame could answer.
    bool is_behind() const { return !m_input.is_empty(); }
    /// Whether the person did anything that this frame answers.
    bool has_input() const { return m_has_input; }
    /// Takes what was done on another window as if it had been done on this one.
    void also_take(const std::vector<gpu::InputEvent>& events) { m_input.add(events); }
    /// Makes what a first frame at that scale would have to wait for; begin() does, too.
    void make_ready(float scale);
    bool is_ready() const { return m_scale > 0.0f; }
    /// Draws a pixel as panels are drawn, when it is ready and into what they will be seen in: a
    /// driver makes its code when it is first drawn with.
    void draw_first();
    /// Begins a frame at a scale of text and controls; `scale` 1 is the display's own.
    void begin(float scale);
    /// Draws what was asked for since begin().
    void end();

    /// What is wrong with the number that was typed last, once; "" when nothing is.
    std::string take_complaint() { return std::exchange(m_typing.complaint, {}); }

    /// CPU time of this thread from begin() to the end of the last frame's panels; what GL then
    /// makes of their triangles does not count.
    double panel_milliseconds() const { return m_panel_milliseconds; }

    const Fonts& fonts() const { return m_fonts.fonts; }
    /// Where the pointer has been since the last frame, in order, in coordinates of the window.
    const std::vector<gpu::PointerEvent>& pointer_path() const { return m_pointer_path; }
    /// Coordinates of the window a pixel of the layout.
    float scale() const { return m_scale; }
    /// Device pixels a coordinate of the window.
    float density() const { return m_density; }

private:
    void set_scale(float scale, float density);
    void take_input();

    gpu::Window& m_window;
    InputQueue m_input;
    BuiltFonts m_fonts;
    Typing m_typing;
    std::vector<gpu::PointerEvent> m_pointer_path;
    bool m_has_input = false;
    double m_begin_seconds = 0.0;
    double m_panel_milliseconds = 0.0;
    float m_scale = 0.0f;
    float m_density = 1.0f;
};
