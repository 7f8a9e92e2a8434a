#include "ui/window/application.h"

#include "gpu/objects/draw.h"
#include "gpu/window.h"
#include "lab/document/content_edits.h"
#include "lab/menus/palette.h"
#include "lab/menus/window_menu.h"
#include "lab/safe_start.h"
#include "lab/session.h"
#include "lab/session/first_file.h"
#include "lab/session/session_keeper.h"
#include "lab/storage/event_waker.h"
#include "lab/storage/injected_fault.h"
#include "lab/views/displayed_passes.h"
#include "lab/views/pending_fits.h"
#include "lab/window/window_session.h"
#include "ui/actions/action_table.h"
#include "ui/picture/first_steps.h"
#include "ui/widgets/theme.h"
#include "ui/window/menu_bar.h"
#include "ui/window/output_window.h"
#include "ui/window/state_file.h"
#include "ui/window/toolkit.h"
#include "ui/window/window_panes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <utility>

namespace {
using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point start, Clock::time_point end) {
    return std::chrono::duration<double>(end - start).count();
}

// Drawing continues after an event: widgets react a frame or two later, tooltips after a delay.
constexpr auto awake = std::chrono::milliseconds(450);

// Maximum delay of the panels for the first picture.
constexpr double picture_patience_seconds = 0.25;

// Whether displayed results are still pending. On a slow machine they take long.
bool is_pending(const Lab& lab, const Views& views) {
    const ComparedPictures& compared = views.main().compared();
    const Comparison& chosen = lab.frames().comparison().selection().chosen();
    const bool awaits_distances = compared.difference() && !compared.distances();
    const bool awaits_stops = chosen.has_equal_brightness && compared.other() && !compared.stops();
    return awaits_distances || awaits_stops || views.is_pending();
}

/// The initial state of the window.
struct Start {
    WindowState state;
    FirstFile first_file = {};
};

// Opens the look of the command line, otherwise the last session.
void open_first(const WindowOptions& options, const Session& session, Lab& lab, Start& start) {
    std::optional<std::string> look = options.look;
    if (look && FirstFile::is_one(*look)) {
        start.first_file = FirstFile(*std::exchange(look, {}));
    }
    if (look)
        lab.looks().keep_unsaved(session);
    start.state.first_steps.is_shown = session.look.empty();
    lab.parameters().set_all(session.parameter_settings);
    lab.content().set_initial(content_of(session));
    (void)lab.player().mute_input(true);  // until the user chooses a live input
    lab.frames().comparison().set_all_slots(session.slots);
    lab.presets().navigation().stars() = (session.preset_stars);
    if (look)
        lab.looks().open(*look);
    else
        restore_safely(lab, session, find_unfinished_opening(options.roots));
}

/// The window and its main loop.
class Application {
public:
    /// `lab` must outlive the application; it is already opening a look.
    Application(const WindowOptions& options, gpu::Window& window, Lab& lab, BuiltFonts fonts,
                Views views, Start start)
        : m_options(options),
          m_window(window),
          m_toolkit(window, std::move(fonts)),
          m_lab(lab),
          m_first_file(std::move(start.first_file)),
          m_views(std::move(views)),
          m_state(std::move(start.state)),
          m_waker(m_lab.loader().files().descriptor(), [] { gpu::WindowEvents::wake(); }) {}

    /// False if the driver has lost the window's context.
    bool run() {
        SessionKeeper keeper(m_options.roots);
        while (!m_is_quitting && !m_window.is_close_requested()) {
            if (has_lost_context()) {
                if (const OpenRequest* opened = m_lab.loader().opened())
                    m_lab.loader().mark().leave(*opened);
                return false;
            }
            if (wait())
                update();
            keeper.update(m_lab, m_state);
        }
        keeper.save(m_lab, m_state);
        constexpr auto patience = std::chrono::milliseconds(500);
        if (!m_lab.loader().worker().end(patience))
            std::_Exit(EXIT_SUCCESS);  // all is saved; nothing else would end that thread
        return true;
    }

private:
    bool wait();  // whether an update is due
    bool has_lost_context() const;
    Extent view() const;
    void update();
    void follow_output();
    bool awaits_picture();
    bool is_before_panels(Clock::time_point now);
    void make_panels_ready(double wall_seconds);
    void list_looks(double wall_seconds);
    bool is_attended(Clock::time_point now);
    void note_pace(double wall_seconds);
    void follow_remote();
    void draw();
    void apply(const Edits& edits);
    void offer_move();
    void note_geometry();
    void update_title();

    const WindowOptions& m_options;
    gpu::Window& m_window;
    Toolkit m_toolkit;
    const ActionTable m_actions = make_action_table();
    OutputWindow m_output;
    Lab& m_lab;
    FirstFile m_first_file;
    Views m_views;
    HistoryPictures m_history_pictures;
    PresetPictures m_preset_pictures{[] { gpu::WindowEvents::wake(); }};
    KeptPictures m_kept_pictures;
    WindowState m_state;
    LibraryView m_library_view;
    Pace m_pace;
    EventWaker m_waker;
    EventWaker m_midi_waker{m_lab.remote().midi().descriptor(), [] { gpu::WindowEvents::wake(); }};
    std::optional<EventWaker> m_remote_waker;  // while other programs can set parameters
    int m_remote_port = 0;
    std::string m_title;
    std::string m_state_text;
    Clock::time_point m_last = Clock::now();
    Clock::time_point m_awake_until = Clock::now() + awake;
    Clock::time_point m_attended_until = m_awake_until;
    Clock::time_point m_drawn = m_last;
    double m_frame_seconds = 0.0;  // since the last complete frame of the picture
    long m_frame_number = 0;
    bool m_has_had_picture = false;           // a look has been drawn
    std::optional<bool> m_waits_for_display;  // as last set on the window
    bool m_is_quitting = false;
};

// While idle, waits for input or file changes, and returns false about once a second to update the
// session. Otherwise limits updates to the chosen frame rate.
bool Application::wait() {
    constexpr double rest_seconds = 1.0;
    const Clock::time_point start = Clock::now();
    if (m_lab.is_moving())
        m_awake_until = start + awake;  // measurements of the last frame follow later
    const bool is_incomplete =
        is_pending(m_lab, m_views) || m_views.is_specializing() || m_state.views.pending.is_any();
    const auto longer = std::chrono::seconds(is_incomplete ? 10 : 0);
    if (!m_lab.is_moving() && !m_toolkit.is_behind() && start > m_awake_until + longer) {
        gpu::WindowEvents::wait(rest_seconds);
        if (seconds_between(start, Clock::now()) >= rest_seconds)
            return false;
        m_awake_until = Clock::now() + awake;
        return true;
    }
    const double frame = m_state.frame_rate.frame_seconds(m_window.refresh_rate());
    const double left = frame - seconds_between(m_last, start);
    constexpr double slack = 0.001;
    if (left > slack && !m_lab.frames().is_amid_frame())
        gpu::WindowEvents::wait(left - slack);
    else
        gpu::WindowEvents::poll();
    return true;
}

bool Application::has_lost_context() const {
    constexpr int injected_frame = 30;
    return gpu::was_reset() || (m_frame_number >= injected_frame && take_injected_reset());
}

// The size in pixels of a picture that follows the view: that of the output window if it is open.
// Empty before the first panels.
Extent Application::view() const {
    return m_state.views.sizes.output.is_empty() ? m_state.views.sizes.picture
                                                 : m_state.views.sizes.output;
}

void Application::update() {
    const Clock::time_point now = Clock::now();
    const double wall_seconds = seconds_between(m_last, now);
    m_last = now;
    note_pace(wall_seconds);
    follow_output();
    if (const Extent seen = view(); !seen.is_empty())
        m_lab.work().size.set_view(seen);
    m_lab.frames().nan_guard().set_unattended(m_state.layout.is_picture_only || m_output.is_open());
    m_lab.frames().set_displayed(displayed_passes(m_lab, m_state));
    m_lab.update(wall_seconds);
    m_first_file.update(m_lab);
    follow_remote();
    if (m_window.framebuffer_size().is_empty())
        return;  // minimised
    if (is_before_panels(now))
        return make_panels_ready(wall_seconds);
    if ((m_lab.frames().is_amid_frame() || awaits_picture()) && !is_attended(now))
        return;  // a slow look gets all of the time
    m_drawn = now;
    list_looks(wall_seconds);
    m_views.update(m_lab, m_state);
    answer_pending_fits(m_views, m_lab, m_state);
    m_history_pictures.update(m_lab, m_views);
    m_preset_pictures.update(m_lab, m_state.layout.sees(PanelId::presets), wall_seconds,
                             m_state.presets.shows_own_content && m_lab.document()
                                 ? std::optional(content_of(*m_lab.document()))
                                 : std::nullopt);
    draw();
}

void Application::follow_output() {
    const bool was_open = m_output.is_open();
    if (std::string problem = m_output.follow(m_state.output, m_window); !problem.empty())
        m_lab.messages().say(std::move(problem), true);
    m_state.views.sizes.output = m_output.extent();
    if (!was_open && m_output.is_open())
        offer_display_size(m_lab, m_state.views.sizes.output);
}

void Application::list_looks(double wall_seconds) {
    m_library_view.update(m_lab.work().library,
                          m_lab.document() ? &m_lab.document()->look() : nullptr, wall_seconds);
}

// Prepares the panels while the first picture is still being loaded.
void Application::make_panels_ready(double wall_seconds) {
    if (!m_toolkit.is_ready()) {
        gpu::bind_screen(m_window.framebuffer_size());
        m_toolkit.make_ready(static_cast<float>(m_state.geometry.scale));
        m_toolkit.draw_first();
    }
    list_looks(wall_seconds);
}

// Measures frames of the picture; a slow one spans many updates.
void Application::note_pace(double wall_seconds) {
    const bool was_amid = m_frame_seconds > 0.0;
    m_frame_seconds += wall_seconds;
    if (m_lab.frames().is_amid_frame())
        return;
    const double seconds = std::exchange(m_frame_seconds, 0.0);
    m_pace.add(seconds, was_amid);
    m_pace.expect(seconds,
                  m_lab.is_moving() && m_state.frame_rate.wants_30(m_window.refresh_rate()));
}

// Whether the first picture of all is still pending.
bool Application::awaits_picture() {
    m_has_had_picture = m_has_had_picture || (m_lab.renderer() && m_lab.renderer()->has_drawn());
    const bool is_coming = m_lab.loader().is_loading() || m_lab.frames().is_amid_frame();
    return is_coming && !m_has_had_picture;
}

// The panels wait briefly, so that a fast first picture is displayed with them. Without stored
// panel sizes, the size of the picture is unknown.
bool Application::is_before_panels(Clock::time_point now) {
    return m_frame_number == 0 && awaits_picture() && !m_state.views.sizes.picture.is_empty() &&
           seconds_between(m_drawn, now) < picture_patience_seconds;
}

// Whether the panels need a new frame now. Otherwise they are drawn ten times a second.
bool Application::is_attended(Clock::time_point now) {
    constexpr double now_and_then = 0.1;
    if (m_frame_number == 0 || m_window.events().has_input() || m_toolkit.is_behind() ||
        seconds_between(m_drawn, now) > now_and_then)
        return true;
    return !awaits_picture() && (now < m_attended_until || m_lab.loader().is_loading());
}

void Application::follow_remote() {
    const int port = m_lab.remote().osc().port();
    if (port == m_remote_port)
        return;
    m_remote_port = port;  // another port can have the same descriptor
    m_remote_waker.emplace(m_lab.remote().osc().descriptor(), [] { gpu::WindowEvents::wake(); });
}

void Application::draw() {
    gpu::bind_screen(m_window.framebuffer_size());
    const theme::Color back = theme::surround;
    gpu::clear_screen({back.red, back.green, back.blue, 1.0f});
    m_toolkit.also_take(m_output.take_keys());
    m_toolkit.begin(static_cast<float>(m_state.geometry.scale));
    Edits edits;
    const Scene scene{m_lab,
                      m_state,
                      m_views,
                      m_history_pictures,
                      m_preset_pictures,
                      m_kept_pictures,
                      m_library_view,
                      m_pace,
                      m_output.monitor(),
                      m_output.covers_panels(),
                      m_toolkit.fonts(),
                      m_actions,
                      ++m_frame_number,
                      m_toolkit.is_behind(),
                      m_toolkit.scale(),
                      m_toolkit.density(),
                      m_toolkit.pointer_path(),
                      m_toolkit.panel_milliseconds()};
    edits.arrange([](WindowState& state) {  // panels set them again
        state.probes.pointer.reset();
        state.parameters.pointed.reset();
        state.probes.scan_place.reset();
    });
    draw_window(scene, edits);
    for (const std::filesystem::path& file : m_window.events().take_dropped_files())
        edits.open_file(file);
    m_toolkit.end();
    if (std::string complaint = m_toolkit.take_complaint(); !complaint.empty())
        m_lab.messages().say(std::move(complaint), true);
    m_window.swap();
    m_output.show(m_views.main().output(), m_window);
    if (!m_options.state_file.empty())
        if (std::string text = state_text(scene, edits); text != m_state_text)
            write_state(m_options.state_file, m_state_text = std::move(text));
    apply(edits);
}

void Application::apply(const Edits& edits) {
    edits.apply(m_lab, m_state);
    for (const std::filesystem::path& file : m_lab.work().opened_files.take())
        note_use(m_state.recent.files, std::filesystem::absolute(file).lexically_normal().string());
    note_first_steps(m_lab, m_state);
    if (edits.has_verbs() || m_toolkit.has_input())  // changes are displayed one frame later
        m_attended_until = m_awake_until = Clock::now() + awake;
    if (edits.has_verbs())
        m_library_view.refresh();
    if (edits.copied())
        m_window.set_clipboard(*edits.copied());
    m_is_quitting = edits.is_quitting();
    const bool waits = m_state.frame_rate.waits_for_display && !m_output.is_open();
    if (waits != m_waits_for_display)  // only one window waits, to avoid waiting twice
        m_window.set_vsync(*(m_waits_for_display = waits));
    offer_move();
    note_geometry();
    update_title();
}

void Application::offer_move() {
    if (m_state.presets.has_offered_move || !m_lab.renderer() || !m_lab.renderer()->has_drawn() ||
        m_lab.messages().notice())
        return;
    m_state.presets.has_offered_move = true;
    m_lab.presets().offer_move();
}

void Application::note_geometry() {
    m_state.geometry.is_maximised = m_window.is_maximised();
    if (m_state.geometry.is_maximised)
        return;
    m_state.geometry.size = m_window.size();
    m_state.geometry.position = m_window.position();
}

void Application::update_title() {
    const std::string open = title_of(m_lab);
    std::string title = open.empty() ? "Afterglow" : fmt::format("{} – Afterglow", open);
    if (title != m_title)
        m_window.set_title(m_title = std::move(title));
}

gpu::WindowOptions geometry_of(const WindowState& state) {
    return {.title = "Afterglow",
            .size = state.geometry.size,
            .position = state.geometry.position,
            .is_maximised = state.geometry.is_maximised};
}
}  // namespace

namespace {
// Runs a window until it is closed. False: the driver has lost its context.
Result<bool> run_once(const WindowOptions& options) {
    Diagnostics warnings;
    const Session session = load_session(options.roots, warnings);
    Start start{restored_window(session.window)};
    auto fonts = build_fonts_async(fitted_scale(static_cast<float>(start.state.geometry.scale)));
    auto window = gpu::Window::open(geometry_of(start.state));
    if (!window)
        return fail(window.error());
    Lab lab(Library(options.roots), (*window)->context(), nullptr);
    lab.loader().worker().set_wake([] { gpu::WindowEvents::wake(); });
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

Result<void> run_window(const WindowOptions& options) {
    constexpr int most_resets = 3;
    WindowOptions again = options;
    for (int resets = 0; resets <= most_resets; ++resets) {
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
