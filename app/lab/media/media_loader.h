#pragma once

#include "base/diagnostic.h"
#include "base/work.h"
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

/// A sound or source that was asked for, read; or why it could not be.
struct LoadedMedia {
    std::string name;                    // as it was asked for
    std::shared_ptr<const Sound> sound;  // one of these
    std::shared_ptr<const BeamScene> scene;
    std::shared_ptr<const Drawing> drawing;
    std::optional<Source> source;
    std::string digest;    // of a file
    Diagnostics problems;  // why nothing was read
    Diagnostics notes;     // what is not as it should be in what was read
};

/// Reads sounds and pictures on a thread of its own, one at a time; a new one replaces what is
/// under way.
class MediaLoader {
public:
    /// A signal's file is a sound, or a scene or drawing by its name.
    enum class Kind { signal, source };

    MediaLoader();
    ~MediaLoader();
    MediaLoader(const MediaLoader&) = delete;
    MediaLoader& operator=(const MediaLoader&) = delete;

    /// `name` is a file, or a source as Source::open takes it.
    void load(Kind kind, const std::string& name);
    void cancel();
    /// What is under way; "" when nothing is.
    std::string name() const;
    double share() const;  // of it, 0..1
    /// What has been read, once; what was cancelled or replaced never comes.
    std::optional<LoadedMedia> take_finished();

private:
    struct Job {
        Kind kind;
        std::string name;
        std::shared_ptr<Work> work;
    };

    void run();

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Job> m_job;      // waits for the thread
    std::optional<Job> m_current;  // waiting or at work
    std::optional<LoadedMedia> m_finished;
    bool m_is_ending = false;
    std::thread m_thread;
};
