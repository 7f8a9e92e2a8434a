#include "lab/media/media_loader.h"

#include "io/files/file_digest.h"
#include "lab/playback/signal_file.h"

#include <utility>

namespace {
LoadedMedia read_signal(const std::string& name, JobProgress& work) {
    LoadedMedia loaded;
    loaded.name = name;
    auto media = load_signal_media(name, &work, &loaded.notes);
    if (!media) {
        loaded.problems = std::move(media.error());
        return loaded;
    }
    loaded.sound = std::move(media->sound);
    loaded.scene = std::move(media->scene);
    loaded.drawing = std::move(media->drawing);
    return loaded;
}

LoadedMedia read_source(const std::string& name) {
    LoadedMedia loaded;
    loaded.name = name;
    auto source = Source::open(name, LiveReading::newest);
    if (!source)
        loaded.problems = std::move(source.error());
    else
        loaded.source = std::move(*source);
    return loaded;
}

// The file to compute a digest of, for presets. Films are too large to read completely.
std::string file_to_digest(const LoadedMedia& loaded) {
    if (!loaded.problems.empty())
        return {};
    if (!loaded.source)
        return loaded.name;
    const bool is_file = !loaded.source->moves() && loaded.source->spec().is_file();
    return is_file ? loaded.source->spec().picture : std::string();
}
}  // namespace

MediaLoader::MediaLoader() : m_thread([this] { run(); }) {}

MediaLoader::~MediaLoader() {
    cancel();
    {
        const std::lock_guard lock(m_mutex);
        m_is_ending = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

void MediaLoader::load(Kind kind, const std::string& name) {
    cancel();
    {
        const std::lock_guard lock(m_mutex);
        m_job = m_current = Job{kind, name, std::make_shared<JobProgress>()};
    }
    m_wake.notify_all();
}

void MediaLoader::cancel() {
    const std::lock_guard lock(m_mutex);
    if (m_current)
        m_current->work->is_cancelled = true;
    m_job.reset();
    m_current.reset();
    m_finished.reset();
}

std::string MediaLoader::name() const {
    const std::lock_guard lock(m_mutex);
    return m_current ? m_current->name : std::string();
}

double MediaLoader::share() const {
    const std::lock_guard lock(m_mutex);
    return m_current ? m_current->work->share.load() : 0.0;
}

std::optional<LoadedMedia> MediaLoader::take_finished() {
    const std::lock_guard lock(m_mutex);
    if (m_finished)
        m_current.reset();
    return std::exchange(m_finished, std::nullopt);
}

void MediaLoader::run() {
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_is_ending || m_job; });
        if (m_is_ending)
            return;
        const Job job = *std::exchange(m_job, std::nullopt);
        lock.unlock();
        LoadedMedia loaded =
            job.kind == Kind::signal ? read_signal(job.name, *job.work) : read_source(job.name);
        if (const std::string file = file_to_digest(loaded); !file.empty())
            if (const auto digest = file_digest(file, job.work.get()))
                loaded.digest = *digest;
        lock.lock();
        if (!job.work->is_cancelled)
            m_finished = std::move(loaded);
    }
}
