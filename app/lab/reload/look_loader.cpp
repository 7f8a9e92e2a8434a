#include "lab/reload/look_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

namespace {
// Of first draws. A reload takes less of each update, so that it does not show as a longer frame.
constexpr double opening_seconds_per_update = 0.012;
constexpr double reload_seconds_per_update = 0.002;
}  // namespace

LookLoader::LookLoader(std::unique_ptr<gpu::Context> context, const gpu::Context& screen,
                       const Roots& roots, Messages& messages)
    : m_messages(messages),
      m_mark(roots),
      m_contexts(screen),
      m_worker(std::move(context), screen, roots) {}

void LookLoader::open(const OpenRequest& request, std::function<void()> then) {
    submit(request, false);
    m_then = std::move(then);
}

void LookLoader::reload() {
    if (m_asked)
        submit(*m_asked, true);
}

void LookLoader::reload_stack(const Stack& stack, const Values& values) {
    if (!m_asked || m_asked->stack == stack)
        return;
    OpenRequest request = *m_asked;
    request.stack = stack;
    request.constants = values;
    submit(std::move(request), true);
}

void LookLoader::dismiss_failed() {
    if (std::exchange(m_failed, {}).empty() || !m_opened)
        return;
    m_is_asked_unopened = false;
    m_then = {};  // it belongs to the look that failed
    submit(*m_opened, true);
}

void LookLoader::cancel() {
    if (!is_reading())
        return;
    m_pending.reset();
    m_then = {};
    m_is_asked_unopened = false;
    const auto cancelled = std::exchange(m_asked, m_opened);
    m_worker.queue().cancel(JobKind::look);
    m_messages.say(
        fmt::format("Cancelled opening \"{}\"", cancelled ? name_of(*cancelled) : std::string()));
}

void LookLoader::submit(OpenRequest request, bool is_reload, const fs::path& edited) {
    m_asked = request;
    m_mark.begin(request, edited);
    Job job{.request = std::move(request), .is_reload = is_reload, .seen = m_displayed};
    job.is_opening = !is_reload || m_is_asked_unopened || !m_programs.shown();
    std::promise<std::shared_ptr<LookContext>> coming;
    if (job.is_opening) {
        job.coming_context = coming.get_future();
    } else {
        create_worker_context();
        job.shown = m_programs.shown();
        job.context = job.shown->context;
        job.key = m_programs.key();
    }
    const bool is_opening = job.is_opening;
    m_pending.reset();
    m_worker.queue().submit(std::move(job));
    if (is_opening)  // a driver takes a while to create it, and the look is read meanwhile
        acquire_context(coming);
}

// Without a context for the look the worker uses its own.
void LookLoader::acquire_context(std::promise<std::shared_ptr<LookContext>>& coming) {
    auto context = m_contexts.acquire();
    if (!context)
        create_worker_context();
    coming.set_value(context);
    if (context)
        context->build_view_programs();
}

void LookLoader::create_worker_context() {
    m_worker.context().create();
    m_worker.queue().wake();
}

void LookLoader::build(Job job) {
    create_worker_context();
    job.is_reload = true;
    job.shown = m_programs.shown();
    job.context = job.shown ? job.shown->context : nullptr;
    if (job.kind == JobKind::constants && m_asked) {
        OpenRequest same = job.request;
        same.constants = m_asked->constants;
        if (same == *m_asked)
            m_asked->constants = job.request.constants;  // for when it is read again
    }
    if (!job.specialization)
        m_mark.begin(job.request, {});
    m_worker.queue().submit(std::move(job));
}

std::optional<LookLoader::Opening> LookLoader::opening() const {
    constexpr double noticed_seconds = 0.3;
    if (!m_asked || m_reading_seconds <= noticed_seconds)
        return std::nullopt;
    return Opening{name_of(*m_asked),
                   m_pending ? m_pending->progress() : m_worker.queue().progress()};
}

bool LookLoader::is_opening_preset(const fs::path& file) const {
    return is_reading() && m_asked && m_asked->preset_file == file;
}

bool LookLoader::is_loading() const {
    const JobQueue& queue = m_worker.queue();
    return m_pending || queue.is_busy(JobKind::look) || queue.is_busy(JobKind::constants) ||
           queue.is_busy(JobKind::variant_constants);
}

bool LookLoader::is_reading() const {
    return m_worker.queue().is_busy(JobKind::look) ||
           (m_pending && m_pending->built().kind == JobKind::look);
}

std::vector<fs::path> LookLoader::take_changed_files() {
    WatchedFiles::Changes changes = m_files.take_changes();
    if (!changes.look_file.empty() && m_asked)
        submit(*m_asked, true, changes.look_file);
    return std::move(changes.extra);
}

// Constants that are ready are not replaced by newer ones, or none would be shown while they
// change.
void LookLoader::take_built() {
    if (m_pending && m_pending->built().kind != JobKind::look)
        return;
    for (const JobKind kind : {JobKind::look, JobKind::constants, JobKind::variant_constants})
        if (auto built = m_worker.queue().take(kind)) {
            m_pending = std::make_unique<PendingLook>(std::move(*built));
            return;
        }
}

std::optional<BuiltLook> LookLoader::update(const OpenLook& open_look, double wall_seconds) {
    constexpr double longest_update = 0.1;  // idle time before an update does not count
    m_reading_seconds =
        is_reading() ? m_reading_seconds + std::min(wall_seconds, longest_update) : 0.0;
    if (std::string problem = m_files.take_problem(); !problem.empty())
        m_messages.say(std::move(problem), true);
    take_built();
    if (!m_pending)
        return std::nullopt;
    const bool waits = m_pending->built().kind != JobKind::look && open_look.has_unfinished_frame;
    const double seconds =
        m_pending->built().is_reload ? reload_seconds_per_update : opening_seconds_per_update;
    if (waits || !m_pending->update({m_programs.shown().get(), open_look.picture}, seconds))
        return std::nullopt;
    BuiltLook built = std::exchange(m_pending, nullptr)->take();
    if (!accept(built))
        return std::nullopt;
    if (built.kind == JobKind::look)
        built.then = std::exchange(m_then, {});
    return built;
}

// Whether the look is to be drawn.
bool LookLoader::accept(const BuiltLook& built) {
    const bool is_built = built.look && built.programs;
    if (built.kind == JobKind::variant_constants) {
        if (!is_built && !built.problems.empty())
            m_messages.say(built.problems.front());
        return is_built;
    }
    if (built.kind == JobKind::constants) {
        if (m_failed.empty())
            m_messages.set_look_problems(built.problems);
        if (is_built)
            m_opened->constants = built.request.constants;
        return is_built;
    }
    m_files.watch_look(built.files);
    const bool is_of_open_look = built.is_reload && m_failed.empty();
    m_failed = is_built || is_of_open_look || !m_opened ? "" : name_of(built.request);
    m_messages.set_look_problems(built.problems);
    m_is_asked_unopened = !m_failed.empty();
    if (is_built)
        m_opened = built.request;
    return is_built;
}

void LookLoader::note_update(bool is_quiet) {
    m_mark.note_update(is_quiet);
    if (!is_quiet)
        return;
    if (m_worker.builder().is_prepared() && !is_loading()) {  // one per update
        if (!m_worker.context().is_created())
            create_worker_context();
        else if (m_programs.shown() && m_programs.shown()->context)
            m_contexts.prepare_spare();
    }
    m_worker.allow_preparation();
}
