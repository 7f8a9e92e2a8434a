#pragma once

#include "base/diagnostic.h"
#include "base/job_progress.h"
#include "lab/media/source.h"
#include "model/devices/sound.h"
#include "signals/drawing/drawing.h"
#include "signals/drawing/scene.h"

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

/// A loaded sound or source, or the errors.
struct LoadedMedia {
    std::string name;                    // as requested
    std::shared_ptr<const Sound> sound;  // only one of these is set
    std::shared_ptr<const BeamScene> scene;
    std::shared_ptr<const Drawing> drawing;
    std::optional<Source> source;
    std::string digest;    // of the file
    Diagnostics problems;  // errors; nothing was loaded
    Diagnostics notes;     // warnings about the loaded file
};

/// Loads sounds and pictures on a background thread, one at a time. A new request replaces the
/// current one.
class MediaLoader {
public:
    /// For `signal`, a file is a scene or drawing by its name, otherwise a sound.
    enum class Kind { signal, source };

    MediaLoader();
    ~MediaLoader();
    MediaLoader(const MediaLoader&) = delete;
    MediaLoader& operator=(const MediaLoader&) = delete;

    /// `name`: a file, or a source as for Source::open().
    void load(Kind kind, const std::string& name);
    void cancel();
    /// The current request; "": idle.
    std::string name() const;
    double share() const;  // progress, 0..1
    /// The loaded file, once. Cancelled and replaced requests are discarded.
    std::optional<LoadedMedia> take_finished();

private:
    struct Job {
        Kind kind;
        std::string name;
        std::shared_ptr<JobProgress> work;
    };

    void run();

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Job> m_job;      // waits for the thread
    std::optional<Job> m_current;  // waiting or running
    std::optional<LoadedMedia> m_finished;
    bool m_is_ending = false;
    std::thread m_thread;
};
