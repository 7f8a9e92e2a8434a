#pragma once

#include "gpu/window.h"
#include "ui/frame/fonts.h"
#include "ui/widgets/typed_number.h"
#include "ui/window/input_queue.h"

#include <string>
#include <utility>
#include <vector>

/// ImGui in a window: context, fonts and both backends. Only one can exist at a time.
class Toolkit {
public:
    /// `fonts` are used if their scale matches the display; otherwise they are rebuilt.
    Toolkit(gpu::Window& window, BuiltFonts fonts);
    ~Toolkit();
    Toolkit(const Toolkit&) = delete;
    Toolkit& operator=(const Toolkit&) = delete;

    /// Whether the pointer rests on a control whose tooltip is due soon.
    bool awaits_tooltip() const;
    /// Whether input events wait for the next frame.
    bool is_behind() const { return !m_input.is_empty(); }
    /// Whether this frame contains input events.
    bool has_input() const { return m_has_input; }
    /// Adds events of another window.
    void add_events(const std::vector<gpu::InputEvent>& events) { m_input.add(events); }
    /// Creates the resources for a first frame at this scale; begin() does the same.
    void make_ready(float scale);
    bool is_ready() const { return m_scale > 0.0f; }
    /// Draws one pixel like a panel, into the panels' framebuffer, after make_ready(). The driver
    /// then compiles the shaders before the first visible frame.
    void draw_first();
    /// Begins a frame at a scale of text and controls; 1 is the scale of the display.
    void begin(float scale);
    /// Draws everything since begin().
    void end();

    /// The error in the last typed number, once; "": no error.
    std::string take_complaint() { return std::exchange(m_typing.complaint, {}); }

    /// CPU time of this thread from begin() to the end of the last frame's panels. Does not include
    /// GL's drawing.
    double panel_milliseconds() const { return m_panel_milliseconds; }

    const Fonts& fonts() const { return m_fonts.fonts; }
    /// The pointer positions since the last frame, in order, in window coordinates.
    const std::vector<gpu::PointerEvent>& pointer_path() const { return m_pointer_path; }
    /// Window coordinates per layout pixel.
    float scale() const { return m_scale; }
    /// Device pixels per window coordinate.
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
