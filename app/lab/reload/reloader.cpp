#include "lab/reload/reloader.h"

#include "formats/stack/stack_format.h"
#include "lab/storage/kept_shaders.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
std::string no_hot_reload(const Diagnostics& reasons) {
    return fmt::format("Hot reload is off: {}", to_string(reasons.front()));
}
}  // namespace

Reloader::Reloader(std::unique_ptr<gpu::Context> context, const gpu::Context& screen,
                   const Roots& roots)
    : m_includes(roots.include_folders()),
      m_kept_shaders(kept_shaders(roots)),
      m_screen(screen),
      m_context(std::move(context)),
      m_drawing_contexts(screen),
      m_mark(roots),
      m_checks(m_kept_shaders.get(), roots.shader_limits) {
    if (auto watcher = FileWatcher::start())
        m_watcher = std::make_unique<FileWatcher>(std::move(*watcher));
    else
        m_watch_problem = no_hot_reload(watcher.error());
    m_thread = std::thread([this] { run(); });
}

Reloader::~Reloader() {
    {
        const std::lock_guard lock(m_mutex);
        m_is_ending = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

bool Reloader::end(std::chrono::milliseconds patience) {
    std::unique_lock lock(m_mutex);
    m_is_ending = true;
    if (m_progress)
        m_progress->cancel();
    drop_turning();
    m_wake.notify_all();
    return m_end.wait_for(lock, patience, [this] { return m_has_ended; });
}

// On the thread of the window. A driver may take a while to make it.
void Reloader::have_context() {
    if (m_context || std::exchange(m_has_asked_for_context, true))
        return;
    auto made = gpu::Context::shared_with(m_screen);
    if (!made)
        return;  // what needs it says so
    {
        const std::lock_guard lock(m_mutex);
        m_context = std::move(*made);
    }
    m_wake.notify_all();
}

bool Reloader::take_own_context() {
    const std::lock_guard lock(m_mutex);
    if (!m_context)
        return false;
    if (gpu::Context::current() != m_context.get())
        m_context->make_current();
    m_borrowed.reset();
    return true;
}

// Its own, or the home of a look that is opened, in which nobody draws yet; false: there is none.
bool Reloader::take_context(const Job& job, std::optional<gpu::ContextScope>& borrowed) {
    if (take_own_context())
        return true;
    if (!job.is_opening || !job.home)
        return false;
    m_borrowed = job.home;
    borrowed.emplace(m_borrowed.get());
    return true;
}

void Reloader::open(const OpenRequest& request) {
    submit(request, false);
}

void Reloader::go_back_to(const OpenRequest& request) {
    m_is_unopened = false;
    submit(request, true);
}

void Reloader::set_shown(const Programs& programs) {
    m_shown = std::make_shared<const Programs>(programs);
    m_is_unopened = false;
}

void Reloader::reload() {
    if (m_request)
        submit(*m_request, true);
}

void Reloader::set_include_folders(IncludeFolders folders) {
    std::unique_lock lock(m_mutex);
    m_includes = std::move(folders);
    lock.unlock();
    reload();
}

void Reloader::restack(const Stack& stack, const Values& values) {
    if (!m_request || m_request->stack == stack)
        return;
    OpenRequest request = *m_request;
    request.stack = stack;
    request.constants = values;
    submit(std::move(request), true);
}

void Reloader::turn(const OpenRequest& request, LoadedRequest::Whose whose) {
    if (m_request && whose == LoadedRequest::Whose::turned) {
        OpenRequest same = request;
        same.constants = m_request->constants;
        if (same == *m_request)
            m_request->constants = request.constants;  // where it is read again
    }
    have_context();
    begin_mark(request);
    {
        const std::lock_guard lock(m_mutex);
        drop_settling();
        turning(whose).next = Job{.request = request,
                                  .is_reload = true,
                                  .generation = m_submitted,
                                  .progress = std::make_shared<PassProgress>(),
                                  .whose = whose,
                                  .shown = m_shown,
                                  .home = home_of_shown()};
    }
    m_wake.notify_all();
}

// To be called with the mutex held.
void Reloader::drop_turning() {
    if (m_turning)
        m_turning->cancel();
    m_turned = {};
    m_variant = {};
    drop_settling();
}

// To be called with the mutex held.
void Reloader::drop_settling() {
    if (m_settling)
        m_settling->cancel();
    m_settling.reset();
    m_settled = {};
}

void Reloader::settle(SettledRequest request) {
    have_context();
    {
        const std::lock_guard lock(m_mutex);
        drop_settling();
        m_settling = std::make_shared<PassProgress>();
        m_settled.next = Job{.request = {},
                             .generation = m_submitted,
                             .progress = m_settling,
                             .whose = LoadedRequest::Whose::settled,
                             .shown = m_shown,
                             .home = home_of_shown(),
                             .settled = std::make_shared<const SettledRequest>(std::move(request))};
    }
    m_wake.notify_all();
}

void Reloader::stop_settling() {
    const std::lock_guard lock(m_mutex);
    drop_settling();
}

std::optional<LoadedRequest> Reloader::take_settled() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_settled.made, std::nullopt);
}

void Reloader::submit(OpenRequest request, bool is_reload) {
    m_request = request;
    begin_mark(request);
    Job job{.request = std::move(request), .is_reload = is_reload, .seen = m_seen};
    job.is_opening = !is_reload || m_is_unopened || !m_shown;
    if (!job.is_opening) {
        job.shown = m_shown;
        job.rest = m_rest;
    }
    const bool is_opening = job.is_opening;
    std::promise<std::shared_ptr<DrawingHome>> lent;
    if (is_opening)
        job.lending = lent.get_future();
    else
        job.home = m_shown->home;
    if (!is_opening)
        have_context();
    {
        const std::lock_guard lock(m_mutex);
        if (m_progress)
            m_progress->cancel();
        job.progress = m_progress = std::make_shared<PassProgress>();
        job.generation = ++m_submitted;
        m_job = std::move(job);
        m_finished.reset();
        drop_turning();
    }
    m_wake.notify_all();
    if (is_opening)  // a driver may take a while to make it, and the look is read meanwhile
        lend(lent);
}

// Where there is no home for it the look is read with the thread's own context.
void Reloader::lend(std::promise<std::shared_ptr<DrawingHome>>& lent) {
    auto home = m_drawing_contexts.lend();
    if (!home)
        have_context();
    lent.set_value(home);
    if (home)
        home->have_programs();
}

void Reloader::wait_for_home(Job& job) {
    if (!job.is_opening)
        return;
    job.lent = job.lending.get();
    if (job.lent)
        job.home = {job.lent, &job.lent->context()};
}

void Reloader::cancel(std::optional<OpenRequest> open) {
    m_is_unopened = false;
    m_request = std::move(open);
    const std::lock_guard lock(m_mutex);
    if (m_progress)
        m_progress->cancel();
    m_job.reset();
    m_finished.reset();
    drop_turning();
    m_completed = ++m_submitted;
}

PassProgress::State Reloader::progress() const {
    const std::lock_guard lock(m_mutex);
    return m_progress ? m_progress->state() : PassProgress::State{};
}

std::vector<fs::path> Reloader::update() {
    std::vector<fs::path> extra;
    if (!m_watcher)
        return extra;
    bool is_look_changed = false;
    for (const fs::path& file : m_watcher->take_changed()) {
        if (std::find(m_look_files.begin(), m_look_files.end(), file) != m_look_files.end()) {
            is_look_changed = true;
            m_edited = file;
        }
        if (std::find(m_extra_files.begin(), m_extra_files.end(), file) != m_extra_files.end())
            extra.push_back(file);
    }
    if (is_look_changed)
        reload();
    return extra;
}

void Reloader::watch_also(std::vector<fs::path> files) {
    if (files == m_extra_files)
        return;
    m_extra_files = std::move(files);
    watch_all();
}

void Reloader::watch_look(const std::vector<fs::path>& files) {
    if (m_is_watching && files == m_look_files)
        return;
    m_look_files = files;
    watch_all();
}

void Reloader::watch_all() {
    std::vector<fs::path> all = m_look_files;
    all.insert(all.end(), m_extra_files.begin(), m_extra_files.end());
    if (!m_watcher)
        return;
    const auto watched = m_watcher->watch(all);
    m_is_watching = watched.has_value();
    if (!watched)
        m_watch_problem = no_hot_reload(watched.error());
}

std::optional<LoadedRequest> Reloader::take_finished() {
    std::optional<LoadedRequest> finished;
    {
        const std::lock_guard lock(m_mutex);
        for (std::optional<LoadedRequest>* made : {&m_finished, &m_turned.made, &m_variant.made})
            if (!finished)
                finished.swap(*made);
    }
    return finished;
}

bool Reloader::is_busy() const {
    if (is_reading())
        return true;
    const std::lock_guard lock(m_mutex);
    const auto is_under_way = [](const Turning& turning) { return turning.next || turning.made; };
    return m_turning || is_under_way(m_turned) || is_under_way(m_variant);
}

bool Reloader::is_reading() const {
    const std::lock_guard lock(m_mutex);
    return m_completed != m_submitted || m_finished;
}

// What is to be read goes first. To be called with the mutex held, as the next one is.
std::optional<Reloader::Job> Reloader::take_job() {
    std::optional<Job> job;
    for (std::optional<Job>* next : {&m_job, &m_turned.next, &m_variant.next, &m_settled.next})
        if (!job)
            job.swap(*next);
    if (job && job->whose != LoadedRequest::Whose::look && !job->settled)
        m_turning = job->progress;
    return job;
}

void Reloader::keep(LoadedRequest loaded) {
    m_turning.reset();
    const bool is_newest = loaded.generation == m_submitted;  // else it is older than its text
    if (loaded.whose == LoadedRequest::Whose::look) {
        m_completed = std::max(m_completed, loaded.generation);
        if (is_newest)
            m_finished = std::move(loaded);
    } else if (loaded.whose == LoadedRequest::Whose::settled) {
        m_settled.made = std::move(loaded);
    } else if (is_newest) {
        turning(loaded.whose).made = std::move(loaded);
    }
}

void Reloader::prepare_for_more() {
    if (m_is_prepared && !is_busy()) {  // one a turn
        if (!m_context && !m_has_asked_for_context)
            have_context();
        else if (home_of_shown())
            m_drawing_contexts.have_spare();
    }
    {
        const std::lock_guard lock(m_mutex);
        if (std::exchange(m_is_preparing, true))
            return;
    }
    m_wake.notify_all();
}

void Reloader::work_on(Job job) {
    {
        LoadedRequest loaded = job.settled ? load_settled(job) : load(job);
        const std::lock_guard lock(m_mutex);
        if (!job.settled || !job.progress->is_cancelled())
            keep(std::move(loaded));
    }
    if (m_wake_owner)
        m_wake_owner();
}

void Reloader::run() {
    constexpr auto rest = std::chrono::seconds(1);  // what is seen first has the machine to itself
    std::unique_lock lock(m_mutex);
    for (;;) {
        std::optional<Job> job;
        const auto has_work = [&] { return m_is_ending || (job = take_job()); };
        m_wake.wait(lock, [&] { return has_work() || can_prepare(); });
        const bool prepares = !m_is_ending && !job && !m_wake.wait_for(lock, rest, has_work);
        if (m_is_ending)
            break;
        lock.unlock();
        if (job)
            work_on(std::move(*job));
        else if (prepares)
            prepare();
        lock.lock();
    }
    m_finished.reset();
    drop_turning();
    lock.unlock();
    {
        const gpu::ContextScope scope(m_borrowed.get());
        m_linked.reset();
        m_read.clear();
        m_warm_up.reset();
    }
    m_borrowed.reset();
    if (gpu::Context* const own = gpu::Context::current())
        own->release();
    lock.lock();
    m_has_ended = true;
    m_end.notify_all();
}

namespace {
Diagnostics no_context() {
    return {{{}, 0, "the graphics driver can't create another OpenGL context"}};
}
}  // namespace

LoadedLook Reloader::read(const Job& job, const Values& values) {
    m_checks.set_keeping(job.whose == LoadedRequest::Whose::look);
    m_shader_files.begin_reading();
    std::unique_lock lock(m_mutex);
    const IncludeFolders includes = m_includes;
    lock.unlock();
    return load_stack(stack_of(job.request), includes,
                      {&m_checks, job.progress.get(), &values, &m_shader_files});
}

LoadedRequest Reloader::load(Job& job) {
    LoadedRequest loaded;
    loaded.request = job.request;
    loaded.is_reload = job.is_reload;
    loaded.generation = job.generation;
    loaded.whose = job.whose;
    const auto refuse = [&loaded](const Diagnostics& why) {
        loaded.problems.insert(loaded.problems.begin(), why.begin(), why.end());
        return std::move(loaded);
    };
    const Values values = values_of(job.request);
    LoadedLook read = this->read(job, values);
    loaded.files = std::move(read.files);
    loaded.problems = std::move(read.warnings);
    if (!read.look)
        return refuse(read.look.error());
    wait_for_home(job);
    std::optional<gpu::ContextScope> borrowed;
    if (!take_context(job, borrowed))
        return refuse(no_context());
    auto images = load_images(*read.look, loaded.problems);
    if (!images)
        return refuse(images.error());
    loaded.images = std::move(*images);
    loaded.look = std::move(*read.look);
    auto programs = link(job, loaded);
    if (!programs) {
        loaded.look.reset();
        return refuse(programs.error());
    }
    loaded.programs = std::move(*programs);
    if (job.whose == LoadedRequest::Whose::look && !job.progress->is_cancelled())
        look_first(job, loaded, values);
    return loaded;
}
