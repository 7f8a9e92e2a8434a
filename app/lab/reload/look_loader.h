#pragma once

#include "lab/messages/messages.h"
#include "lab/reload/build_worker.h"
#include "lab/reload/crash_marker.h"
#include "lab/reload/pending_look.h"
#include "lab/reload/program_set.h"
#include "lab/reload/watched_files.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Opens looks and reloads them when their files change. Looks are read and built on a worker
/// thread, then warmed up in the context that draws them; the open look continues meanwhile.
class LookLoader {
public:
    /// `context` is for the worker thread and shares objects with `screen`, the context of this
    /// thread; null: one is created when it is needed.
    LookLoader(std::unique_ptr<gpu::Context> context, const gpu::Context& screen,
               const Roots& roots, Messages& messages);

    /// Opens another look or preset, and calls `then` when it has opened. Cancels a look that is
    /// being opened.
    void open(const OpenRequest& request, std::function<void()> then = {});
    /// Keeps the open look instead of the one that is being opened.
    void cancel();
    /// Reads the open look again although no file changed.
    void reload();
    /// Reads the looks of another stack, once; `values` by the names of that stack.
    void reload_stack(const Stack& stack, const Values& values);
    /// Opens the open look again after another one could not be opened.
    void dismiss_failed();

    /// The request that the open look came from; null: none is open.
    const OpenRequest* opened() const { return m_opened ? &*m_opened : nullptr; }
    /// The look that could not be opened; "": the problems are those of the open look.
    const std::string& failed() const { return m_failed; }
    struct Opening {
        std::string look;
        PassProgress::State progress;
    };
    /// A look that takes a while to open; nullopt: none.
    std::optional<Opening> opening() const;
    bool is_opening_preset(const std::filesystem::path& file) const;
    /// Whether a look is read, or constants of the open one are built.
    bool is_loading() const;
    bool is_reading() const;

    /// What the open look draws meanwhile.
    struct OpenLook {
        Extent picture;                     // px
        bool has_unfinished_frame = false;  // constants wait, which would drop the unfinished frame
    };
    /// Warms up a built look. Returns it when it can be drawn, with look and programs. Shows the
    /// problems of looks that could not be built.
    std::optional<BuiltLook> update(const OpenLook& open_look, double wall_seconds);
    /// Call once per update. `is_quiet`: nothing is loaded and the picture is complete. After a few
    /// such updates the look counts as opened, and the worker prepares for edits.
    void note_update(bool is_quiet);
    /// Reads changed looks again. Returns the extra files that changed.
    std::vector<std::filesystem::path> take_changed_files();

    /// Builds something for the open look: constants or a specialisation.
    void build(Job job);
    ProgramSet& programs() { return m_programs; }
    const ProgramSet& programs() const { return m_programs; }
    BuildWorker& worker() { return m_worker; }
    WatchedFiles& files() { return m_files; }
    CrashMarker& mark() { return m_mark; }
    /// The displayed passes of looks that will be opened.
    void set_displayed(PassSelection passes) { m_displayed = std::move(passes); }

private:
    void submit(OpenRequest request, bool is_reload, const std::filesystem::path& edited = {});
    void acquire_context(std::promise<std::shared_ptr<LookContext>>& coming);
    void create_worker_context();
    void take_built();
    bool accept(const BuiltLook& built);

    Messages& m_messages;
    CrashMarker m_mark;
    WatchedFiles m_files;
    LookContexts m_contexts;
    BuildWorker m_worker;
    std::optional<OpenRequest> m_asked;
    bool m_is_asked_unopened = false;  // m_asked could not be opened: reading it again opens it
    std::optional<OpenRequest> m_opened;
    std::function<void()> m_then;  // called when m_asked has opened
    std::string m_failed;
    double m_reading_seconds = 0.0;
    std::unique_ptr<PendingLook> m_pending;  // the newest one; null: none was built
    PassSelection m_displayed;
    ProgramSet m_programs;
};
