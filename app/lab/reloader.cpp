#include "lab/reloader.h"

#include "formats/stack_format.h"
#include "graph/warm_up.h"
#include "io/picture_codec.h"
#include "lab/kept_shaders.h"
#include "lab/look_media.h"

#include <algorithm>

namespace fs = std::filesystem;

Reloader::Reloader(std::unique_ptr<gpu::Context> context, const Roots& roots)
    : m_shared_includes(roots.shared_includes()),
      m_kept_shaders(kept_shaders(roots)),
      m_context(std::move(context)) {
    if (auto watcher = FileWatcher::start())
        m_watcher = std::make_unique<FileWatcher>(std::move(*watcher));
    else
        m_watch_problem = "edits will not be seen: " + to_string(watcher.error().front());
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

void Reloader::open(const OpenRequest& request) {
    submit(request, false);
}

void Reloader::reload() {
    if (m_request)
        submit(*m_request, true);
}

void Reloader::restack(const Stack& stack) {
    if (!m_request || m_request->stack == stack)
        return;
    OpenRequest request = *m_request;
    request.stack = stack;
    submit(std::move(request), true);
}

void Reloader::submit(OpenRequest request, bool is_reload) {
    m_request = request;
    {
        const std::lock_guard lock(m_mutex);
        m_job = Job{std::move(request), is_reload, ++m_submitted};
        m_finished.reset();
    }
    m_wake.notify_all();
}

std::vector<fs::path> Reloader::update() {
    std::vector<fs::path> extra;
    if (!m_watcher)
        return extra;
    bool is_look_changed = false;
    for (const fs::path& file : m_watcher->take_changed()) {
        if (std::find(m_look_files.begin(), m_look_files.end(), file) != m_look_files.end())
            is_look_changed = true;
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
    watch(m_look_files);
}

void Reloader::watch(const std::vector<fs::path>& files) {
    m_look_files = files;
    std::vector<fs::path> all = files;
    all.insert(all.end(), m_extra_files.begin(), m_extra_files.end());
    if (!m_watcher)
        return;
    if (const auto watched = m_watcher->watch(all); !watched)
        m_watch_problem = "edits will not be seen: " + to_string(watched.error().front());
}

std::optional<LoadedRequest> Reloader::take_finished() {
    std::optional<LoadedRequest> finished;
    {
        const std::lock_guard lock(m_mutex);
        finished.swap(m_finished);
    }
    if (finished)
        watch(finished->files);
    return finished;
}

bool Reloader::is_busy() const {
    const std::lock_guard lock(m_mutex);
    return m_completed != m_submitted || m_finished;
}

namespace {
// The first picture that a person chooses must not hold up the window. Why the module cannot be
// loaded is told by who reads a picture.
void load_picture_module() {
    static_cast<void>(picture_codec());
}
}  // namespace

void Reloader::run() {
    m_context->make_current();
    warm_up();
    if (auto made = WarmUp::make())
        m_warm_up.emplace(std::move(*made));
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_is_ending || m_job; });
        if (m_is_ending)
            break;
        const Job job = std::move(*m_job);
        m_job.reset();
        lock.unlock();
        LoadedRequest loaded = load(job);
        lock.lock();
        m_completed = job.generation;
        if (job.generation == m_submitted)  // else it is older than the newest text
            m_finished = std::move(loaded);
        lock.unlock();
        load_picture_module();
        lock.lock();
    }
    lock.unlock();
    m_finished.reset();
    m_linked.reset();
    m_warm_up.reset();
    m_context->release();
}

Result<LoadedImages> Reloader::load_images(const Look& look, Diagnostics& warnings) {
    LoadedImages images;
    std::map<fs::path, ReadImage> read;
    Diagnostics problems;
    for (const Image& image : look.images) {
        std::error_code error;
        const auto time = fs::last_write_time(image.file, error);
        const auto before = m_read.find(image.file);
        if (!error && before != m_read.end() && before->second.time == time) {
            images[image.name] = before->second.picture;
        } else {
            auto picture = load_image(image, warnings);
            if (!picture)
                problems.insert(problems.end(), picture.error().begin(), picture.error().end());
            if (!picture || !*picture)
                continue;
            images[image.name] = std::make_shared<const Picture>(std::move(**picture));
        }
        read[image.file] = {time, images[image.name]};
    }
    m_read = std::move(read);
    if (!problems.empty())
        return fail(std::move(problems));
    return images;
}

LoadedRequest Reloader::load(const Job& job) {
    LoadedRequest loaded{job.request, job.is_reload, {}, {}, {}, {}, {}};
    LoadedLook read = load_stack(stack_of(job.request), m_shared_includes, &m_checks);
    loaded.files = std::move(read.files);
    loaded.problems = std::move(read.warnings);
    if (!read.look) {
        loaded.problems.insert(loaded.problems.begin(), read.look.error().begin(),
                               read.look.error().end());
        return loaded;
    }
    auto images = load_images(*read.look, loaded.problems);
    if (!images) {
        loaded.problems.insert(loaded.problems.begin(), images.error().begin(),
                               images.error().end());
        return loaded;
    }
    loaded.images = std::move(*images);
    auto programs =
        build_programs(*read.look, m_linked ? &*m_linked : nullptr, m_kept_shaders.get());
    if (!programs) {
        loaded.problems.insert(loaded.problems.begin(), programs.error().begin(),
                               programs.error().end());
        return loaded;
    }
    if (m_warm_up)
        m_warm_up->draw(*read.look, *programs, m_linked ? &*m_linked : nullptr, m_picture);
    m_linked = *programs;
    loaded.look = std::move(*read.look);
    loaded.programs = std::move(*programs);
    return loaded;
}
