#include "lab/reload/program_builder.h"

#include "glsl/compile/check.h"
#include "gpu/driver_cache.h"
#include "gpu/objects/draw.h"
#include "graph/inspect/nan_detector.h"
#include "graph/warm_up/warm_up.h"
#include "io/pictures/picture_codec.h"
#include "lab/storage/injected_fault.h"

namespace {
constexpr auto cache_timeout = std::chrono::milliseconds(500);

// The first picture that the user chooses must not block the window. Readers of pictures report an
// error if the module cannot be loaded.
void load_picture_module() {
    static_cast<void>(picture_codec());
}

Diagnostics no_context() {
    return {{{}, 0, "the graphics driver can't create another OpenGL context"}};
}

// The objects of the context that draws a look are shared by all of its programs.
void share_context_objects(const Programs& from, Programs& to) {
    to.nan_detector = from.nan_detector;
    to.views = from.views;
    to.first_views = from.first_views;
}

void wait_for_context(Job& job) {
    if (!job.is_opening)
        return;
    job.look_context = job.coming_context.get();
    if (job.look_context)
        job.context = {job.look_context, &job.look_context->context()};
}
}  // namespace

void ProgramBuilder::build(Job& job, BuiltLook& built) {
    const auto refuse = [&built](const Diagnostics& why) {
        built.problems.insert(built.problems.begin(), why.begin(), why.end());
        built.look.reset();
    };
    wait_for_context(job);
    std::optional<gpu::ContextScope> scope;
    if (!m_context.use(job.is_opening ? job.context : nullptr, scope))
        return refuse(no_context());
    auto images = m_images.load(*built.look, built.problems);
    if (!images)
        return refuse(images.error());
    built.images = std::move(*images);
    auto programs = link(job, built);
    if (!programs)
        return refuse(programs.error());
    built.programs = std::move(*programs);
    if (job.kind == JobKind::look && !job.progress->is_cancelled())
        view_first(job, built);
}

// Constants change during a drag. They are not stored between runs, and not warmed up, because with
// a busy GPU they would be late.
Result<Programs> ProgramBuilder::link(const Job& job, BuiltLook& built) {
    trigger_injected_fault();
    const bool is_look = job.kind == JobKind::look;
    const std::optional<Programs> reusable = known_programs(job, *built.look);
    const Programs* const known = reusable ? &*reusable : nullptr;
    auto programs = build_programs(*built.look, known, is_look ? m_store.get() : nullptr,
                                   job.progress.get(), known ? known->context : job.context);
    if (!programs)
        return programs;
    if (known)
        share_context_objects(*known, *programs);
    else if (auto added = add_view_programs(job, *programs); !added)
        return fail(added.error());
    if (is_look) {
        built.specialized = specialize(job, built, *programs, known);
        if (built.specialized)
            draw_first_here(job, known, built.specialized->programs, built.specialized->look,
                            built.images);
        draw_first(job, known, *programs, built);
    }
    if (!job.progress->is_cancelled())
        remember(*programs, built);
    return programs;
}

// A text that returns, after an undo in the editor, finds its programs here.
void ProgramBuilder::remember(const Programs& programs, const BuiltLook& built) {
    constexpr std::size_t max_builds = 6;  // each edit adds few programs
    std::erase_if(m_recent,
                  [&](const Programs& other) { return other.context != programs.context; });
    m_recent.push_front(built.specialized ? joined(programs, built.specialized->programs)
                                          : programs);
    if (m_recent.size() > max_builds)
        m_recent.pop_back();
}

// For the open look: its current programs and those of recent builds. For another look: those of
// the latest build if it is the same look.
std::optional<Programs> ProgramBuilder::known_programs(const Job& job, const Look& look) const {
    std::optional<Programs> known;
    const auto add = [&known](const Programs& programs) {
        known = known ? joined(std::move(*known), programs) : programs;
    };
    if (job.is_opening) {
        if (!m_recent.empty() && serves(m_recent.front(), look))
            add(m_recent.front());
    } else {
        for (const Programs& programs : m_recent)
            if (programs.context == job.context)
                add(programs);
    }
    if (job.shown)
        add(*job.shown);
    return known;
}

// Built once for all looks that draw in a context.
Result<void> ProgramBuilder::add_view_programs(const Job& job, Programs& programs) {
    if (!job.look_context) {
        auto made = ViewPrograms::make();
        if (!made)
            return fail(made.error());
        programs.views = std::make_shared<const ViewPrograms>(std::move(*made));
        return {};
    }
    const gpu::ContextScope scope(job.context.get());
    const auto views = job.look_context->views();
    if (!views)
        return fail(views.error());
    programs.first_views = {job.look_context, *views};
    programs.views = {job.look_context, (*views)->programs().get()};
    return {};
}

// nullopt if no values are static, passes were added or removed, or the driver refuses.
std::optional<SpecializedLook> ProgramBuilder::specialize(const Job& job, const BuiltLook& built,
                                                          const Programs& generic,
                                                          const Programs* known) {
    if (!job.key || job.key->plan.targets.size() != built.look->passes.size())
        return std::nullopt;
    const auto is_moving = [&job](const Parameter& parameter) {
        return job.key->moving.contains(parameter.name);
    };
    SpecializedLook specialized{specialized_look(*built.look, job.key->values, job.key->plan,
                                                 is_moving, m_specialized_texts),
                                {},
                                job.key};
    auto programs =
        build_programs(specialized.look, known, nullptr, job.progress.get(), generic.context);
    if (!programs)
        return std::nullopt;
    specialized.programs = std::move(*programs);
    share_context_objects(generic, specialized.programs);
    return specialized;
}

BuiltLook ProgramBuilder::build_specialized(const Job& job) {
    const SpecializationRequest& asked = *job.specialization;
    BuiltLook built{.kind = job.kind, .request = {}, .images = asked.images};
    const auto is_moving = [&asked](const Parameter& parameter) {
        return asked.key->moving.contains(parameter.name);
    };
    built.look = specialized_look(asked.look, asked.key->values, asked.key->plan, is_moving,
                                  m_specialized_texts);
    std::optional<gpu::ContextScope> scope;
    if (!m_context.use(nullptr, scope))
        return built;
    auto programs =
        build_programs(*built.look, job.shown.get(), nullptr, job.progress.get(), job.context);
    if (!programs)
        return built;
    if (job.shown)
        share_context_objects(*job.shown, *programs);
    draw_first(job, job.shown.get(), *programs, built);
    built.programs = std::move(*programs);
    return built;
}

// Draws in the context that will draw the look if no other thread draws there, otherwise here.
void ProgramBuilder::draw_first(const Job& job, const Programs* known, Programs& programs,
                                BuiltLook& built) {
    built.is_warm = job.is_opening && job.context && programs.context == job.context;
    if (built.is_warm)
        draw_first_in_look_context(job, programs, built);
    else
        draw_first_here(job, known, programs, *built.look, built.images);
}

// The executor continues to draw the look, because allocating its targets takes longer than the
// first draws.
void ProgramBuilder::draw_first_in_look_context(const Job& job, Programs& programs,
                                                BuiltLook& built) {
    const gpu::ContextScope scope(job.context.get());
    if (auto made = build_nan_detector(job.context))
        programs.nan_detector = std::move(*made);
    WarmUp warm_up(job.context);
    warm_up.add_draws({.look = *built.look,
                       .programs = programs,
                       .images = built.images,
                       .viewport = m_picture,
                       .size = FirstDrawsInput::Size::own,
                       .values = values_of(job.request),
                       .seen = job.seen.of(*built.look)});
    warm_up.draw_all(*job.progress);
    built.executor = warm_up.take_executor();
    gpu::finish();
}

// The look's context is in use on another thread. It gets the result from the driver's cache.
void ProgramBuilder::draw_first_here(const Job& job, const Programs* known,
                                     const Programs& programs, const Look& look,
                                     const ImageTextures& images) {
    if (!has_new(programs, known))
        return;
    job.progress->begin(PassProgress::Step::drawing, programs.passes.size());
    make_warm_up();
    if (!m_warm_up)
        return;
    Programs drawn = programs;
    drawn.context = nullptr;
    drawn.nan_detector = nullptr;  // their uniforms are in use on another thread
    drawn.views = nullptr;
    m_warm_up->draw({look, drawn, known, images, m_picture, FirstDrawsInput::Size::whole},
                    *job.progress);
    // The look's context finds the result in the cache once it is written.
    gpu::wait_for_driver_cache(cache_timeout, *job.progress);
}

// Views are drawn in the context that draws the passes. The first look is displayed without this
// warm-up.
void ProgramBuilder::view_first(const Job& job, const BuiltLook& built) {
    if (!is_prepared() || !job.look_context || built.programs->context != job.context)
        return;
    WarmUp warm_up(job.context);
    warm_up.add_views(*built.look, *built.programs, m_picture, values_of(job.request));
    warm_up.draw_all(*job.progress);
}

void ProgramBuilder::make_warm_up() {
    if (m_warm_up)
        return;
    if (auto made = WorkerWarmUp::make())
        m_warm_up.emplace(std::move(*made));
}

// The tables of glslang and of the driver, and the picture module, each take longer to load than
// the first picture of a known look. First draws on this thread need a context of its own.
void ProgramBuilder::prepare() {
    if (!is_prepared()) {
        warm_up();
        load_picture_module();
    } else if (m_context.use_own()) {
        make_warm_up();
    }
    ++m_step;
}

void ProgramBuilder::clear() {
    const gpu::ContextScope scope(m_context.look_context().get());
    m_recent.clear();
    m_images.clear();
    m_warm_up.reset();
}
