#pragma once

#include "base/byte_store.h"
#include "base/pass_progress.h"
#include "glsl/cache/check_cache.h"
#include "glsl/text/shader_files.h"
#include "gpu/context.h"
#include "graph/programs/programs.h"
#include "graph/programs/settled_look.h"
#include "graph/warm_up/warm_up.h"
#include "io/files/file_watcher.h"
#include "lab/library/open.h"
#include "lab/reload/drawing_contexts.h"
#include "lab/reload/opening_mark.h"
#include "lab/reload/seen_passes.h"
#include "model/look/picture.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>

/// Values of the open look that rest, and for which programs hold them as constants.
struct Rest {
    Values values;
    Plan plan;
    std::set<std::string> moving;  // parameters that stay uniforms
};

/// A look as it is drawn while values rest.
struct SettledLook {
    Look look;
    Programs programs;
    std::shared_ptr<const Rest> rest;
};

/// What became of one reading of a look.
struct LoadedRequest {
    /// Whose programs they are: of a look that is read; of the open one with constants of its
    /// texts turned, for the picture itself or for what it is compared with; of the open one with
    /// values in its texts.
    enum class Whose { look, turned, variant, settled };

    OpenRequest request;
    bool is_reload = false;  // of the look that is open already
    std::optional<Look> look;
    std::optional<Programs> programs;
    std::optional<SettledLook> settled = {};  // none: nothing rests
    ImageTextures images;  // that the look names; of a file that did not change the same as before
    Diagnostics problems;  // errors when look or programs are missing, else warnings
    std::vector<std::filesystem::path> files;
    std::uint64_t generation = 0;  // of what was asked for
    Whose whose = Whose::look;
    bool is_warm = false;  // where it will be drawn each of its programs has been drawn with
    std::unique_ptr<Executor> executor = {};  // of such a look, at the picture's size and values;
                                              // null: there was no memory
};

/// The open look as it is to be drawn while values rest.
struct SettledRequest {
    Look look;
    std::shared_ptr<const Rest> rest;
    ImageTextures images;
};

/// Reads looks and links their programs on a thread of its own, and watches their files.
class Reloader {
public:
    /// `context` shares objects with `screen`, the one of the caller's thread; from now on it
    /// belongs to the reloader's thread. Null: one is made when a picture is seen or the homes of
    /// looks that are opened will not do.
    Reloader(std::unique_ptr<gpu::Context> context, const gpu::Context& screen, const Roots& roots);
    ~Reloader();
    Reloader(const Reloader&) = delete;
    Reloader& operator=(const Reloader&) = delete;

    /// Reads another look; what was under way is dropped.
    void open(const OpenRequest& request);
    /// Reads the open look again although no file changed.
    void reload();
    /// Looks for includes in these folders from the next reading on; reads the open look again.
    void set_include_folders(IncludeFolders folders);
    /// Reads a look that is open once more, after another could not be opened.
    void go_back_to(const OpenRequest& request);
    /// Nothing comes of what was asked for last; `open` is what is open as before.
    void cancel(std::optional<OpenRequest> open);
    /// What was asked for last; null: nothing yet.
    const OpenRequest* request() const { return m_request ? &*m_request : nullptr; }
    /// Reads the looks of another stack in place of the open ones, once; with values by its names.
    void restack(const Stack& stack, const Values& values);
    /// Makes the open look, which `request` names, with other constants. While one is being made
    /// only the newest waits; each that is made comes, also where another was asked for since.
    void turn(const OpenRequest& request, LoadedRequest::Whose whose);
    /// Makes programs with values in their texts, beside all else and only while there is nothing
    /// else to do; what was asked for before is dropped.
    void settle(SettledRequest request);
    void stop_settling();
    /// What came of settle(), once.
    std::optional<LoadedRequest> take_settled();
    /// What the open look's programs hold now: an edit of it is made ready for the same, so that
    /// its picture goes on as fast. Null: no values rest.
    void set_rest(std::shared_ptr<const Rest> rest) { m_rest = std::move(rest); }
    /// Looks at the watched files and submits the look again when one has changed.
    /// Gives the watched extra files that changed (the open preset, a sound).
    std::vector<std::filesystem::path> update();
    /// How large the picture is, for which programs are made ready.
    void set_picture(Extent picture) { m_picture = picture; }
    /// Which passes of the looks to come somebody looks at.
    void set_seen(const SeenPasses& seen) { m_seen = seen; }
    /// What the open look is drawn with: later readings of it take what they can from there, and
    /// are drawn in its home.
    void set_shown(const Programs& programs);
    /// What its home draws with; null: nothing.
    const Programs* shown() const { return m_shown.get(); }
    /// What was asked for last could not be opened: reading it again opens another look.
    void note_unopened() { m_is_unopened = true; }
    /// The open look's own files: a change of one makes it read again.
    void watch_look(const std::vector<std::filesystem::path>& files);
    const std::vector<std::filesystem::path>& look_files() const { return m_look_files; }
    /// Files besides the look's own that update() reports.
    void watch_also(std::vector<std::filesystem::path> files);
    /// The newest result, once; a result older than the newest submission never comes, turn()
    /// apart.
    std::optional<LoadedRequest> take_finished();
    bool is_busy() const;
    /// Whether a look is being read, and not only turned.
    bool is_reading() const;
    /// Called on the reloader's thread whenever it has done something: there may be a result to
    /// take. To be set before anything is asked for.
    void set_wake(std::function<void()> wake) { m_wake_owner = std::move(wake); }
    /// A picture is seen or there will be none: what only later work needs is made ready.
    void prepare_for_more();
    /// Once a turn: whether nothing is read and the picture is whole. After some such turns in a
    /// row the look counts as opened.
    void note_turn(bool is_quiet) {
        constexpr int enough = 3;
        m_quiet_turns = is_quiet ? m_quiet_turns + 1 : 0;
        if (m_quiet_turns > enough && m_mark.is_set())
            m_mark.end();
    }
    /// The driver lost the context while it drew the open look: the next start is to know.
    void note_reset() {
        if (m_request)
            m_mark.leave(*m_request);
    }
    /// Whether nothing was asked for since.
    bool is_newest(const LoadedRequest& loaded) const { return loaded.generation == m_submitted; }
    /// How far what was asked for last has come.
    PassProgress::State progress() const;
    /// Asks the thread to end and waits so long for it; false: it is stuck in a driver, and the
    /// reloader must not be destroyed.
    bool end(std::chrono::milliseconds patience);
    /// Why edits cannot be seen, once each time that is found out; "" when they can.
    std::string take_watch_problem() { return std::exchange(m_watch_problem, {}); }
    /// Becomes readable when update() has something to see; -1 where files cannot be watched.
    int descriptor() const { return m_watcher ? m_watcher->descriptor() : -1; }

private:
    struct Job {
        OpenRequest request;
        bool is_reload = false;
        std::uint64_t generation = 0;
        std::shared_ptr<PassProgress> progress = {};  // shared with who asked
        LoadedRequest::Whose whose = LoadedRequest::Whose::look;
        std::shared_ptr<const Programs> shown = {};  // of the look that it is of, with former
                                                     // ones; null: another
        std::shared_ptr<gpu::Context> home = {};
        bool is_opening = false;  // then nobody draws in its home yet
        SeenPasses seen = {};
        std::shared_future<std::shared_ptr<DrawingHome>> lending = {};  // then that one to come
        std::shared_ptr<DrawingHome> lent = {};  // when it has come; null: there is none
        std::shared_ptr<const SettledRequest> settled = {};  // null: it is read
        std::shared_ptr<const Rest> rest = {};               // of what is read; null: nothing rests
    };
    /// What turn() asks for: one a picture.
    struct Turning {
        std::optional<Job> next;
        std::optional<LoadedRequest> made;
    };

    std::shared_ptr<gpu::Context> home_of_shown() const {
        return m_shown ? m_shown->home : nullptr;
    }
    void have_context();
    bool take_own_context();
    bool take_context(const Job& job, std::optional<gpu::ContextScope>& borrowed);
    void begin_mark(const OpenRequest& request) {
        m_quiet_turns = 0;
        m_mark.begin(request, std::exchange(m_edited, {}));
    }
    void submit(OpenRequest request, bool is_reload);
    void run();
    void work_on(Job job);
    void watch_all();
    bool can_prepare() const;
    void prepare();
    void make_warm_up();
    std::optional<Job> take_job();
    void keep(LoadedRequest loaded);
    void drop_turning();
    void drop_settling();
    Turning& turning(LoadedRequest::Whose whose) {
        return whose == LoadedRequest::Whose::turned ? m_turned : m_variant;
    }
    LoadedRequest load(Job& job);
    void lend(std::promise<std::shared_ptr<DrawingHome>>& lent);
    LoadedLook read(const Job& job, const Values& values);
    static void wait_for_home(Job& job);
    LoadedRequest load_settled(const Job& job);
    void draw_look_first(const Job& job, const std::optional<Programs>& known, Programs& programs,
                         LoadedRequest& loaded);
    std::optional<SettledLook> settle_first(const Job& job, const Programs& own,
                                            const LoadedRequest& loaded,
                                            const std::optional<Programs>& known);
    std::optional<Programs> known_for(const Job& job, const Look& look) const;
    Result<Programs> link(const Job& job, LoadedRequest& loaded);
    void draw_first(const Job& job, const Programs* known, Programs& programs,
                    LoadedRequest& loaded);
    void draw_first_at_home(const Job& job, Programs& programs, LoadedRequest& loaded);
    void draw_first_here(const Job& job, const Programs* known, const Programs& programs,
                         const Look& look, const ImageTextures& images);
    Result<void> take_views(const Job& job, Programs& programs);
    void look_first(const Job& job, const LoadedRequest& loaded, const Values& values);
    Result<ImageTextures> load_images(const Look& look, Diagnostics& warnings);

    IncludeFolders m_includes;
    std::shared_ptr<ByteStore> m_kept_shaders;  // null: there is no folder for it
    const gpu::Context& m_screen;
    std::unique_ptr<gpu::Context> m_context;  // of the thread, from when it takes it
    bool m_has_asked_for_context = false;
    DrawingContexts m_drawing_contexts;
    std::shared_ptr<const Programs> m_shown;  // of the open look; null: none is open
    bool m_is_unopened = false;
    std::shared_ptr<const Rest> m_rest;
    std::unique_ptr<FileWatcher> m_watcher;
    std::string m_watch_problem;
    std::vector<std::filesystem::path> m_look_files;
    bool m_is_watching = false;  // both kinds of files
    std::vector<std::filesystem::path> m_extra_files;
    std::optional<OpenRequest> m_request;
    SeenPasses m_seen;
    std::function<void()> m_wake_owner;
    std::atomic<Extent> m_picture = Extent{1280, 720};

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::condition_variable m_end;
    std::shared_ptr<PassProgress> m_progress;  // of the newest job
    std::optional<Job> m_job;
    std::optional<LoadedRequest> m_finished;
    Turning m_turned;
    Turning m_variant;
    Turning m_settled;
    std::shared_ptr<PassProgress> m_settling;  // of the one that is being made or waits
    bool m_is_preparing = false;               // prepare_for_more() was asked for
    std::atomic<bool> m_is_prepared = false;   // set by the thread
    bool m_is_ready_for_edits = false;         // the thread's: it has tried to be
    std::shared_ptr<PassProgress> m_turning;   // of the one that is being made; null: none is
    std::uint64_t m_submitted = 0;
    std::uint64_t m_completed = 0;
    bool m_is_ending = false;
    bool m_has_ended = false;

    struct ReadImage {
        std::filesystem::file_time_type time;
        Image image;
        Encoding source_encoding;
        bool is_mipmapped;
        std::shared_ptr<const gpu::Texture> texture;

        bool serves(const ReadImage& other) const {
            return time == other.time && image == other.image &&
                   source_encoding == other.source_encoding && is_mipmapped == other.is_mipmapped;
        }
    };

    OpeningMark m_mark;
    int m_quiet_turns = 0;
    std::filesystem::path m_edited;  // the last change of the look's files; "": none
    CheckCache m_checks;             // the thread's
    ShaderFiles m_shader_files;      // the thread's
    SettledTexts m_settled_texts;    // the thread's
    std::map<std::filesystem::path, ReadImage> m_read;  // the thread's
    std::optional<Programs> m_linked;          // the thread's: what the next reading may reuse
    std::shared_ptr<gpu::Context> m_borrowed;  // the thread's: it has made things there; null: it
                                               // has a context of its own
    std::optional<WarmUp> m_warm_up;           // the thread's; without it the first frame is slower
    std::thread m_thread;
};
