#pragma once

#include "graph/programs/specialized_look.h"
#include "graph/warm_up/worker_warm_up.h"
#include "lab/reload/job_queue.h"
#include "lab/reload/look_images.h"
#include "lab/reload/worker_context.h"

#include <atomic>
#include <deque>
#include <memory>
#include <optional>

/// Builds the programs of looks on the worker thread, and draws once with each. A driver finishes a
/// program at its first draw, which would delay the picture.
class ProgramBuilder {
public:
    /// `store` keeps the driver's binaries between runs; null: not stored.
    ProgramBuilder(WorkerContext& context, std::shared_ptr<ByteStore> store)
        : m_context(context), m_store(std::move(store)) {}

    /// The size of the picture that programs are warmed up for, px. On any thread.
    void set_picture(Extent picture) { m_picture = picture; }
    /// Adds images and programs to a look that was read. On failure the look is removed and its
    /// problems contain the reason.
    void build(Job& job, BuiltLook& built);
    /// Builds specialised programs. Without programs in the result the driver refused them.
    BuiltLook build_specialized(const Job& job);

    /// Loads what the first edits need: the compilers' tables, the picture module, a context.
    void prepare();
    bool can_prepare() const { return m_step == 0 || (m_step == 1 && m_context.is_created()); }
    /// Whether the first step of prepare() is done. On any thread.
    bool is_prepared() const { return m_step > 0; }
    /// Releases all objects, in their context.
    void clear();

private:
    Result<Programs> link(const Job& job, BuiltLook& built);
    std::optional<Programs> known_programs(const Job& job, const Look& look) const;
    void remember(const Programs& programs, const BuiltLook& built);
    Result<void> add_view_programs(const Job& job, Programs& programs);
    std::optional<SpecializedLook> specialize(const Job& job, const BuiltLook& built,
                                              const Programs& generic, const Programs* known);
    void draw_first(const Job& job, const Programs* known, Programs& programs, BuiltLook& built);
    void draw_first_in_look_context(const Job& job, Programs& programs, BuiltLook& built);
    void draw_first_here(const Job& job, const Programs* known, const Programs& programs,
                         const Look& look, const ImageTextures& images);
    void view_first(const Job& job, const BuiltLook& built);
    void make_warm_up();

    WorkerContext& m_context;
    std::shared_ptr<ByteStore> m_store;
    std::atomic<Extent> m_picture = Extent{1280, 720};
    std::atomic<int> m_step = 0;  // completed steps of prepare()
    LookImages m_images;
    SpecializedTexts m_specialized_texts;
    std::deque<Programs> m_recent;          // newest first, of one context, to be reused
    std::optional<WorkerWarmUp> m_warm_up;  // nullopt: the first frame is slower
};
