// The part of Reloader that links programs, and meets with them what the window is not to wait for.
#include "glsl/compile/check.h"
#include "gpu/driver_cache.h"
#include "gpu/objects/draw.h"
#include "graph/warm_up/first_views.h"
#include "io/pictures/picture_codec.h"
#include "lab/reload/reloader.h"
#include "lab/storage/injected_fault.h"
#include "lab/storage/kept_shaders.h"

#include <algorithm>

namespace {
constexpr auto cache_patience = std::chrono::milliseconds(500);

// The first picture that a person chooses must not hold up the window. Why the module cannot be
// loaded is told by who reads a picture.
void load_picture_module() {
    static_cast<void>(picture_codec());
}

}  // namespace

// Each new program draws once: in the home that is new, where it will be drawn with; else here.
void Reloader::draw_first(const Job& job, const Programs* known, Programs& programs,
                          LoadedRequest& loaded) {
    loaded.is_warm = job.is_opening && job.home && programs.home == job.home;
    if (loaded.is_warm)
        draw_first_at_home(job, programs, loaded);
    else
        draw_first_here(job, known, programs, *loaded.look, loaded.images);
}

// Nobody has drawn there yet, so that nothing is known. Who draws next goes on with the targets:
// making room takes longer than a band of each.
void Reloader::draw_first_at_home(const Job& job, Programs& programs, LoadedRequest& loaded) {
    const gpu::ContextScope scope(job.home.get());
    if (auto made = build_tripwire(job.home))
        programs.tripwire = std::move(*made);
    FirstDraws draws({.look = *loaded.look,
                      .programs = programs,
                      .images = loaded.images,
                      .viewport = m_picture,
                      .size = FirstDrawsOf::Size::own,
                      .values = values_of(job.request),
                      .seen = job.seen.of(*loaded.look)},
                     PassProgram{});
    draws.draw_all(*job.progress);
    loaded.executor = draws.take_executor();
    gpu::finish();
}

void Reloader::make_warm_up() {
    if (m_warm_up)
        return;
    if (auto made = WarmUp::make())
        m_warm_up.emplace(std::move(*made));
}

bool Reloader::can_prepare() const {
    return m_is_prepared ? m_context && !m_is_ready_for_edits : m_is_preparing;
}

// The compilers' own tables, glslang's and the driver's, and the module that reads pictures: each
// takes longer than all that the first picture needs where its shaders are known. When there is a
// context of its own, what first draws need.
void Reloader::prepare() {
    if (m_is_prepared) {
        m_is_ready_for_edits = true;
        if (take_own_context())
            make_warm_up();
        return;
    }
    warm_up();
    load_picture_module();
    m_is_prepared = true;
}

// The home is current elsewhere, and what the driver keeps in files of its own will do.
void Reloader::draw_first_here(const Job& job, const Programs* known, const Programs& programs,
                               const Look& look, const ImageTextures& images) {
    if (!has_new(programs, known))
        return;
    job.progress->begin(PassProgress::Step::drawing, programs.passes.size());
    make_warm_up();
    if (!m_warm_up)
        return;
    Programs drawn = programs;
    drawn.home = nullptr;
    drawn.tripwire = nullptr;  // the uniforms of these are somebody else's now
    drawn.views = nullptr;
    m_warm_up->draw({look, drawn, known, images, m_picture, FirstDrawsOf::Size::whole},
                    *job.progress);
    // Or the drawing context finds nothing there.
    gpu::wait_for_driver_cache(cache_patience, *job.progress);
}

// Those of its home are made once for all looks that draw there.
Result<void> Reloader::take_views(const Job& job, Programs& programs) {
    if (!job.lent) {
        auto made = ViewPrograms::make();
        if (!made)
            return fail(made.error());
        programs.views = std::make_shared<const ViewPrograms>(std::move(*made));
        return {};
    }
    const gpu::ContextScope scope(job.home.get());
    const auto views = job.lent->views();
    if (!views)
        return fail(views.error());
    programs.first_views = {job.lent, *views};
    programs.views = {job.lent, (*views)->programs().get()};
    return {};
}

// Who looks at the passes does so where they are drawn. The first look of all is waited for, and
// nothing is seen that it could stop.
void Reloader::look_first(const Job& job, const LoadedRequest& loaded, const Values& values) {
    if (!m_is_prepared || !job.lent || loaded.programs->home != job.home)
        return;
    const auto plan = plan_targets(*loaded.look, m_picture, expected_source, values);
    if (!plan)
        return;  // the look itself will say so
    const gpu::ContextScope scope(job.home.get());
    FirstViews& views = *loaded.programs->first_views;
    views.expect(*loaded.look, *plan);
    while (views.owed() > 0 && !job.progress->is_cancelled())
        views.draw_next();
}

// Whose programs serve: for the open look those that it is or was drawn with, and newer ones beside
// them; for another one only if it is the same.
std::optional<Programs> Reloader::known_for(const Job& job, const Look& look) const {
    const bool serves_linked =
        m_linked && (job.is_opening ? serves(*m_linked, look) : m_linked->home == job.home);
    if (serves_linked && job.shown)
        return joined(*m_linked, *job.shown);
    if (serves_linked)
        return m_linked;
    return job.shown ? std::optional(*job.shown) : std::nullopt;
}

// What a hand goes past is kept for no other run, and does not wait for first draws: where the GPU
// is busy with the picture they come late.
Result<Programs> Reloader::link(const Job& job, LoadedRequest& loaded) {
    fail_as_injected();
    const bool is_look = job.whose == LoadedRequest::Whose::look;
    const std::optional<Programs> reusable = known_for(job, *loaded.look);
    const Programs* const known = reusable ? &*reusable : nullptr;
    auto programs = build_programs(*loaded.look, known, is_look ? m_kept_shaders.get() : nullptr,
                                   job.progress.get(), known ? known->home : job.home);
    if (!programs)
        return programs;
    if (known) {
        programs->tripwire = known->tripwire;
        programs->views = known->views;
        programs->first_views = known->first_views;
    } else {
        if (auto taken = take_views(job, *programs); !taken)
            return fail(taken.error());
    }
    if (is_look)
        draw_look_first(job, reusable, *programs, loaded);
    if (!job.progress->is_cancelled())
        m_linked = *programs;
    return programs;
}

// Where values are static, the look is drawn with specialised programs first. The generic ones
// draw as soon as a value changes.
void Reloader::draw_look_first(const Job& job, const std::optional<Programs>& known,
                               Programs& programs, LoadedRequest& loaded) {
    const Programs* const drawn = known ? &*known : nullptr;
    loaded.settled = settle_first(job, programs, loaded, known);
    if (loaded.settled)
        draw_first_here(job, drawn, loaded.settled->programs, loaded.settled->look, loaded.images);
    draw_first(job, drawn, programs, loaded);
}

// Null where nothing rests, other passes have come, or the driver refuses such programs.
std::optional<SettledLook> Reloader::settle_first(const Job& job, const Programs& own,
                                                  const LoadedRequest& loaded,
                                                  const std::optional<Programs>& known) {
    if (!job.rest || job.rest->plan.targets.size() != loaded.look->passes.size())
        return std::nullopt;
    SettledLook settled{
        settled_look(
            *loaded.look, job.rest->values, job.rest->plan,
            [&](const Parameter& parameter) { return job.rest->moving.contains(parameter.name); },
            m_settled_texts),
        {},
        job.rest};
    auto programs = build_programs(settled.look, known ? &*known : nullptr, nullptr,
                                   job.progress.get(), own.home);
    if (!programs)
        return std::nullopt;
    settled.programs = std::move(*programs);
    settled.programs.tripwire = own.tripwire;
    settled.programs.views = own.views;
    settled.programs.first_views = own.first_views;
    return settled;
}

// Where the driver refuses such programs, what the author wrote goes on.
LoadedRequest Reloader::load_settled(const Job& job) {
    const SettledRequest& asked = *job.settled;
    LoadedRequest loaded;
    loaded.generation = job.generation;
    loaded.whose = job.whose;
    loaded.images = asked.images;
    loaded.look = settled_look(
        asked.look, asked.rest->values, asked.rest->plan,
        [&asked](const Parameter& parameter) {
            return asked.rest->moving.contains(parameter.name);
        },
        m_settled_texts);
    std::optional<gpu::ContextScope> borrowed;
    if (!take_context(job, borrowed))
        return loaded;
    auto programs =
        build_programs(*loaded.look, job.shown.get(), nullptr, job.progress.get(), job.home);
    if (!programs)
        return loaded;
    programs->tripwire = job.shown ? job.shown->tripwire : nullptr;
    programs->views = job.shown ? job.shown->views : nullptr;
    programs->first_views = job.shown ? job.shown->first_views : nullptr;
    draw_first(job, job.shown.get(), *programs, loaded);
    loaded.programs = std::move(*programs);
    return loaded;
}
