#include "ui/window/application.h"

#include "gpu/window.h"
#include "gpu/x11_window.h"
#include "lab/library/library_view.h"
#include "lab/menus/palette.h"
#include "lab/menus/window_menu.h"
#include "lab/output/camera_output.h"
#include "lab/safe_start.h"
#include "lab/session.h"
#include "lab/session/first_file.h"
#include "lab/session/session_autosave.h"
#include "lab/storage/injected_fault.h"
#include "lab/storage/instance_lock.h"
#include "lab/views/displayed_passes.h"
#include "lab/views/flicker.h"
#include "lab/views/picture_clipboard.h"
#include "lab/window/desktop_file_dialog.h"
#include "lab/window/key_store.h"
#include "lab/window/window_session.h"
#include "ui/actions/action_table.h"
#include "ui/panels/panel_table.h"
#include "ui/picture/first_steps.h"
#include "ui/window/desktop_window.h"
#include "ui/window/lab_wakers.h"
#include "ui/window/menu_bar.h"
#include "ui/window/panel_display.h"
#include "ui/window/update_schedule.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <utility>

namespace {
/// The initial state of the window.
struct Start {
    WindowState state;
    FirstFile first_file = {};
    KeyStore keys;
};

// Opens the look of the command line, otherwise the last session.
void open_first(const ApplicationOptions& options, const Session& session, Lab& lab, Start& start) {
    std::optional<std::string> look = options.look;
    if (look && FirstFile::is_one(*look)) {
        start.first_file = FirstFile(*std::exchange(look, {}));
    }
    if (look)
        lab.looks().stash_unsaved(session);
    start.state.first_steps.is_shown = session.look.empty();
    lab.parameters().set_all(session.parameter_settings);
    lab.content().set_initial(content_of(session));
    lab.sequencer().set_initial(session.current.preset.tempo.value_or(Tempo{}),
                                session.current.cues);
    (void)lab.player().mute_input(true);  // until the user chooses a live input
    lab.frames().comparison().set_all_slots(session.slots);
    lab.presets().navigation().stars() = (session.preset_stars);
    if (look)
        lab.looks().open(*look);
    else
        restore_safely(lab, session, find_unfinished_opening(options.roots));
}

/// What other programs get of the picture.
struct PictureUses {
    PictureClipboard clipboard;
    CameraOutput camera{gpu::WindowEvents::wake};
};

/// The window and its main loop.
class Application {
public:
    /// `lab` must outlive the application; it is already opening a look.
    Application(const ApplicationOptions& options, gpu::Window& window, Lab& lab, BuiltFonts fonts,
                Views views, Start start)
        : m_window(window),
          m_lab(lab),
          m_state(std::move(start.state)),
          m_first_file(std::move(start.first_file)),
          m_panels(window, std::move(fonts), std::move(views), options.state_file),
          m_schedule(lab, window.events(), m_panels.toolkit()),
          m_wakers(lab),
          m_desktop(window),
          m_keeper(options.roots),
          m_keys(std::move(start.keys)),
          m_instance(options.roots.instance) {}

    /// False if the driver has lost the window's context.
    bool run() {
        while (!is_ending()) {
            if (has_lost_context()) {
                if (const OpenRequest* opened = m_lab.loader().opened())
                    m_lab.loader().mark().leave(*opened);
                return false;
            }
            if (wait())
                update();
            m_keeper.update(m_lab, m_state);
        }
        m_keeper.save(m_lab, m_state);
        constexpr auto timeout = std::chrono::milliseconds(500);
        if (!m_lab.loader().worker().end(timeout))
            std::_Exit(EXIT_SUCCESS);  // all is saved; nothing else would end that thread
        return true;
    }

private:
    bool is_ending();
    bool wait();  // whether an update is due
    bool has_lost_context() const;
    void update();
    double refresh_rate();
    void follow_output();
    void update_lab(double wall_seconds);
    void apply(const Edits& edits);
    void offer_move();
    void report_other_window();

    gpu::Window& m_window;
    Lab& m_lab;
    WindowState m_state;
    FirstFile m_first_file;
    PanelDisplay m_panels;
    UpdateSchedule m_schedule;
    LabWakers m_wakers;
    DesktopWindow m_desktop;
    DesktopFileDialog m_files{gpu::WindowEvents::wake};
    SessionAutosave m_keeper;
    KeyStore m_keys;
    PictureUses m_picture;
    int m_instance;
    bool m_has_reported_other = false;
    bool m_is_quitting = false;
};

// While exports run, the user is asked before they are cancelled.
bool Application::is_ending() {
    if (!m_window.take_close_request() && !m_is_quitting)
        return false;
    m_schedule.stay_awake();
    if (!m_lab.jobs().exports().is_pending()) {
        m_is_quitting = m_lab.jobs().is_exporting();  // until the last picture is saved
        return !m_is_quitting;
    }
    m_is_quitting = false;
    m_state.dialog = {.kind = Dialog::Kind::quit_exporting};
    return false;
}

bool Application::wait() {
    return m_schedule.wait(m_state.frame_rate.frame_seconds(m_window.refresh_rate()),
                           m_panels.is_pending(m_lab) || m_state.views.pending.is_any());
}

bool Application::has_lost_context() const {
    constexpr int injected_frame = 30;
    return gpu::was_reset() ||
           (m_schedule.frame_number() >= injected_frame && take_injected_reset());
}

void Application::update() {
    const double wall_seconds = m_schedule.begin_update();
    m_panels.pace().update(
        wall_seconds, m_lab.frames().has_unfinished_frame(),
        m_lab.is_moving() && m_state.frame_rate.wants_30(m_window.refresh_rate()));
    const bool waits = m_state.frame_rate.waits_for_display || m_panels.output().is_open();
    m_lab.work().display.add(wall_seconds, refresh_rate(),
                             waits && m_lab.is_moving() && !m_lab.frames().has_unfinished_frame());
    follow_output();
    follow_flicker(m_lab.work(), m_state.flashes);
    m_lab.work().hdr = m_state.hdr.drawn();
    update_lab(wall_seconds);
    m_picture.camera.update(m_state.output, m_lab.renderer(),
                            m_lab.frames().passes().picture_pass(), m_lab.messages());
    if (m_window.framebuffer_size().is_empty())
        return;  // minimised
    // Without stored panel sizes, the size of the picture is unknown.
    if (!m_state.views.sizes.picture.is_empty() && m_schedule.is_before_panels())
        return m_panels.make_ready(m_lab, m_state, wall_seconds);
    if (!m_schedule.are_panels_due())
        return;  // a slow look gets all of the time
    m_files.update(m_state, m_lab.document(), m_lab.messages(), gpu::x11_window(m_window));
    m_schedule.begin_panels();
    m_panels.update(m_lab, m_state, wall_seconds);
    apply(m_panels.draw(m_lab, m_state, m_schedule.frame_number()));
}

// Of the display that the window waits for.
double Application::refresh_rate() {
    const OutputWindow& output = m_panels.output();
    return output.is_open() ? m_window.displays().refresh_rate(output.monitor())
                            : m_window.refresh_rate();
}

void Application::follow_output() {
    OutputWindow& output = m_panels.output();
    const bool was_open = output.is_open();
    const std::string source_window = overlaid_window(m_lab.document());
    if (std::string problem = output.follow(m_state.output, source_window, m_window);
        !problem.empty())
        m_lab.messages().say(std::move(problem), true);
    m_state.views.sizes.output = output.extent();
    if (!was_open && output.is_open() && !output.is_overlay())
        offer_display_size(m_lab.work().size, m_lab.messages(), output.extent());
}

void Application::update_lab(double wall_seconds) {
    // The size in pixels of a picture that follows the view. Empty before the first panels.
    const ViewSizes& sizes = m_state.views.sizes;
    const Extent seen = sizes.output.is_empty() ? sizes.picture : sizes.output;
    if (!seen.is_empty())
        m_lab.work().size.set_view(seen, m_panels.output().is_overlay());
    m_lab.frames().nan_guard().set_unattended(m_state.layout.is_picture_only ||
                                              m_panels.output().is_open());
    m_lab.frames().set_displayed(displayed_passes(m_lab, m_state));
    const bool was_black = m_state.output.is_black;
    m_lab.update(wall_seconds, &m_state);
    if (m_state.output.is_black != was_black || m_lab.remote().requested_action())
        m_schedule.stay_awake();  // the panels show it now, also while a look draws slowly
    m_first_file.update(m_lab);
}

void Application::apply(const Edits& edits) {
    edits.apply(m_lab, m_state);
    for (const std::filesystem::path& file : m_lab.work().opened_files.take())
        note_use(m_state.recent.files, std::filesystem::absolute(file).lexically_normal().string());
    if (const Document* document = m_lab.document())
        note_use(m_state.recent.looks, argument_of(document->look()));
    note_first_steps(m_lab.document(), m_state);
    m_keys.update(m_state.keyboard.bindings, m_lab.messages());
    if (edits.change_lab() || m_panels.toolkit().has_input())  // displayed one frame later
        m_schedule.stay_awake();
    if (edits.change_lab())
        m_panels.library().refresh();
    if (edits.requests().copied)
        m_window.set_clipboard(*edits.requests().copied);
    if (!m_state.copied.empty())
        m_window.set_clipboard(std::exchange(m_state.copied, {}));
    if (edits.requests().copies_picture && m_lab.document() && m_lab.renderer())
        m_picture.clipboard.copy(*m_lab.renderer(), m_lab.frames().passes().picture_pass(),
                                 m_lab.sequencer().drawn_document(), m_lab.work().media.recent(),
                                 m_lab.messages());
    m_is_quitting = m_is_quitting || edits.requests().quits;
    // Only one window waits, to avoid waiting twice.
    m_desktop.set_vsync(m_state.frame_rate.waits_for_display && !m_panels.output().is_open());
    report_other_window();
    offer_move();
    m_desktop.note_geometry(m_state.geometry);
    const std::string number = m_instance > 1 ? fmt::format(" (window {})", m_instance) : "";
    m_desktop.set_title(title_of(m_lab.document()) + number);
}

void Application::offer_move() {
    if (m_state.presets.has_offered_move || !m_lab.renderer() || !m_lab.renderer()->has_drawn() ||
        m_lab.messages().notice())
        return;
    m_state.presets.has_offered_move = true;
    m_lab.presets().offer_move();
}

// After the first picture, because missing devices are reported before.
void Application::report_other_window() {
    if (m_instance <= 1 || m_has_reported_other || !m_lab.renderer() ||
        !m_lab.renderer()->has_drawn())
        return;
    m_has_reported_other = true;
    m_lab.messages().ask(
        "Another Afterglow window is open. This one has its own session and does not listen for "
        "OSC.",
        {{.name = "OK"}}, {}, false);
}

// Runs a window until it is closed. False: the driver has lost its context.
Result<bool> run_once(const ApplicationOptions& options) {
    Diagnostics warnings;
    const Session session = load_session(options.roots, warnings);
    Start start{restored_window(session.window, panel_kinds()), {}, KeyStore(options.roots)};
    start.state.keyboard.bindings = start.keys.load(make_action_table().keyed_actions(), warnings);
    auto fonts = build_fonts_async(fitted_scale(static_cast<float>(start.state.geometry.scale)));
    auto window = gpu::Window::open(geometry_of(start.state.geometry));
    if (!window)
        return fail(window.error());
    Lab lab(Library(options.roots), (*window)->context(), nullptr);
    lab.loader().worker().set_wake(gpu::WindowEvents::wake);
    lab.work().programs.set_wake(gpu::WindowEvents::wake);
    if (!start.state.views.sizes.picture.is_empty())
        lab.work().size.set_view(
            start.state.views.sizes.picture);  // the last size, until the panels report theirs
    if (!warnings.empty())
        lab.messages().say(warnings.front());
    lab.frames().set_displayed(displayed_passes(lab, start.state));
    open_first(options, session, lab, start);
    auto views = Views::make();
    if (!views)
        return fail(views.error());
    Application application(options, **window, lab, fonts.get(), std::move(*views),
                            std::move(start));
    return application.run();
}
}  // namespace

Result<void> run_window(const ApplicationOptions& options) {
    constexpr int max_resets = 3;
    ApplicationOptions again = options;
    const InstanceLock instance = InstanceLock::take(options.roots);
    again.roots.instance = instance.number();
    for (int resets = 0; resets <= max_resets; ++resets) {
        const auto is_closed = run_once(again);
        if (!is_closed)
            return fail(is_closed.error());
        if (*is_closed)
            return {};
        again.look.reset();  // it is now in the session
    }
    return fail(
        {{}, 0, "the graphics driver keeps resetting; close other programs that use the GPU"});
}
