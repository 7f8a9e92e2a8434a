#pragma once

#include "formats/look_format.h"
#include "glsl/parameters.h"
#include "gpu/context.h"
#include "graph/programs.h"
#include "graph/warm_up.h"
#include "io/file_watcher.h"
#include "lab/open.h"
#include "model/picture.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

/// The pictures that a look names in "images", by name.
using LoadedImages = std::map<std::string, std::shared_ptr<const Picture>>;

/// What became of one reading of a look.
struct LoadedRequest {
    OpenRequest request;
    bool is_reload = false;  // of the look that is open already
    std::optional<Look> look;
    std::optional<Programs> programs;
    LoadedImages images;   // a file that did not change is the same picture as before
    Diagnostics problems;  // errors when look or programs are missing, else warnings
    std::vector<std::filesystem::path> files;
};

/// Reads looks and links their programs on a thread of its own, and watches their files.
class Reloader {
public:
    /// `context` shares objects with the drawing one; from now on it belongs to the reloader's
    /// thread.
    Reloader(std::unique_ptr<gpu::Context> context, const Roots& roots);
    ~Reloader();
    Reloader(const Reloader&) = delete;
    Reloader& operator=(const Reloader&) = delete;

    /// Reads another look; what was under way is dropped.
    void open(const OpenRequest& request);
    /// Reads the open look again although no file changed.
    void reload();
    /// Reads a look that is open once more, after another could not be opened.
    void go_back_to(const OpenRequest& request) { submit(request, true); }
    /// What was asked for last; null: nothing yet.
    const OpenRequest* request() const { return m_request ? &*m_request : nullptr; }
    /// Reads the looks of another stack in place of the open ones, once.
    void restack(const Stack& stack);
    /// Looks at the watched files and submits the look again when one has changed.
    /// Gives the watched extra files that changed (the open preset, a sound).
    std::vector<std::filesystem::path> update();
    /// How large the picture is, for which programs are made ready.
    void set_picture(Extent picture) { m_picture = picture; }
    /// Files besides the look's own that update() reports.
    void watch_also(std::vector<std::filesystem::path> files);
    /// The newest result, once; a result older than the newest submission never comes.
    std::optional<LoadedRequest> take_finished();
    bool is_busy() const;
    /// Why edits cannot be seen, once each time that is found out; "" when they can.
    std::string take_watch_problem() { return std::exchange(m_watch_problem, {}); }
    /// Becomes readable when update() has something to see; -1 where files cannot be watched.
    int descriptor() const { return m_watcher ? m_watcher->descriptor() : -1; }

private:
    struct Job {
        OpenRequest request;
        bool is_reload = false;
        std::uint64_t generation = 0;
    };

    void submit(OpenRequest request, bool is_reload);
    void watch(const std::vector<std::filesystem::path>& files);
    void run();
    LoadedRequest load(const Job& job);
    Result<LoadedImages> load_images(const Look& look, Diagnostics& warnings);

    std::filesystem::path m_shared_includes;
    std::shared_ptr<ByteStore> m_kept_shaders;
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<FileWatcher> m_watcher;
    std::string m_watch_problem;
    std::vector<std::filesystem::path> m_look_files;
    std::vector<std::filesystem::path> m_extra_files;
    std::optional<OpenRequest> m_request;
    std::atomic<Extent> m_picture = Extent{1280, 720};

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Job> m_job;
    std::optional<LoadedRequest> m_finished;
    std::uint64_t m_submitted = 0;
    std::uint64_t m_completed = 0;
    bool m_is_ending = false;

    struct ReadImage {
        std::filesystem::file_time_type time;
        std::shared_ptr<const Picture> picture;
    };

    CheckCache m_checks{m_kept_shaders.get()};          // the thread's
    std::map<std::filesystem::path, ReadImage> m_read;  // the thread's
    std::optional<Programs> m_linked;  // the thread's: what the next reading may reuse
    std::optional<WarmUp> m_warm_up;   // the thread's; without it the first frame is slower
    std::thread m_thread;
};
