#include "ui/window/panel_display.h"

#include "gpu/objects/draw.h"
#include "lab/lab.h"
#include "lab/views/pending_fits.h"
#include "ui/dialogs/match_dialog.h"
#include "ui/frame/scene.h"
#include "ui/widgets/theme.h"
#include "ui/window/state_file.h"
#include "ui/window/window_panes.h"

#include <utility>

PanelDisplay::PanelDisplay(gpu::Window& window, BuiltFonts fonts, Views views,
                           std::filesystem::path state_file)
    : m_window(window),
      m_toolkit(window, std::move(fonts)),
      m_views(std::move(views)),
      m_state_file(std::move(state_file)) {}

bool PanelDisplay::is_pending(const Lab& lab) const {
    const ComparedPictures& compared = m_views.main().compared();
    const Comparison& chosen = lab.frames().comparison().selection().chosen();
    const bool awaits_distances = compared.difference() && !compared.distances();
    const bool awaits_stops = chosen.has_equal_brightness && compared.other() && !compared.stops();
    return m_folders.is_reading() || m_pictures.file.is_pending() ||
           m_pictures.presets.is_pending() || awaits_distances || awaits_stops ||
           m_views.is_pending() || m_views.is_transitioning();
}

void PanelDisplay::list_looks(const Lab& lab, double wall_seconds) {
    m_library.update(lab.work().library, lab.document() ? &lab.document()->look() : nullptr,
                     wall_seconds);
}

void PanelDisplay::make_ready(const Lab& lab, const WindowState& state, double wall_seconds) {
    if (!m_toolkit.is_ready()) {
        gpu::bind_screen(m_window.framebuffer_size());
        m_toolkit.make_ready(static_cast<float>(state.geometry.scale));
        m_toolkit.draw_first();
    }
    list_looks(lab, wall_seconds);
}

void PanelDisplay::update(Lab& lab, WindowState& state, double wall_seconds) {
    list_looks(lab, wall_seconds);
    m_folders.update(folder_request(state.dialog, state.file_dialogs));
    m_pictures.file.update(selected_file(state.dialog, m_folders));
    m_views.update(lab, state);
    apply_pending_fits(m_views, lab, state);
    m_pictures.update(lab, m_views, state, m_library, wall_seconds);
}

Edits PanelDisplay::draw(Lab& lab, const WindowState& state, long frame_number) {
    gpu::bind_screen(m_window.framebuffer_size());
    const theme::Color back = theme::surround;
    gpu::clear_screen({back.red, back.green, back.blue, 1.0f});
    m_toolkit.add_events(m_output.take_keys());
    m_toolkit.begin(static_cast<float>(state.geometry.scale));
    m_actions.bind(state.keyboard.bindings);
    Edits edits;
    const LabParts parts = parts_of(lab);
    const Scene scene{.lab = parts,
                      .window = state,
                      .views = m_views,
                      .pictures = m_pictures,
                      .library_view = m_library,
                      .folders = m_folders,
                      .roots = lab.work().library.roots(),
                      .pace = m_pace,
                      .actions = m_actions,
                      .fonts = m_toolkit.fonts(),
                      .frame = {.number = frame_number,
                                .is_behind = m_toolkit.is_behind(),
                                .pointer_path = m_toolkit.pointer_path(),
                                .panel_milliseconds = m_toolkit.panel_milliseconds()},
                      .output_monitor = m_output.monitor(),
                      .is_behind_output = m_output.covers_panels(),
                      .scale = m_toolkit.scale(),
                      .density = m_toolkit.density()};
    edits.arrange([](WindowState& changed) {  // panels set them again
        changed.probes.pointer.reset();
        changed.probes.scan_position.reset();
        changed.parameters.pointed.reset();
        changed.views.timeline.is_hovered = false;
    });
    draw_window(scene, edits);
    for (const std::filesystem::path& file : m_window.events().take_dropped_files())
        open_dropped(file, scene, edits);
    m_toolkit.end();
    if (std::string complaint = m_toolkit.take_complaint(); !complaint.empty())
        lab.messages().say(std::move(complaint), true);
    m_window.swap();
    m_output.show(m_views.main().output(), m_window);
    if (!m_state_file.empty())
        if (std::string text = state_text(scene, edits); text != m_state_text)
            write_state(m_state_file, m_state_text = std::move(text));
    return edits;
}
