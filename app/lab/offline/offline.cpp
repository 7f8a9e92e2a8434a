#include "lab/offline/offline.h"

#include "base/text.h"
#include "gpu/headless_context.h"
#include "gpu/objects/readback.h"
#include "graph/programs/specialized_look.h"
#include "lab/document/content_edits.h"
#include "lab/document/cued_values.h"
#include "lab/document/parameter_edits.h"
#include "lab/document/users_content.h"
#include "lab/media/image_budget.h"
#include "lab/media/look_media.h"
#include "lab/offline/non_finite_text.h"
#include "lab/playback/signal_file.h"
#include "lab/rendering/cued_frame.h"
#include "lab/storage/media.h"
#include "lab/storage/shader_cache.h"
#include "model/picture/black.h"
#include "model/picture/placing.h"
#include "model/plan/parameter_use.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

Offline::Offline(std::unique_ptr<gpu::Context> context, PreparedLook prepared, Programs programs,
                 Extent size, double fps)
    : m_context(std::move(context)),
      m_document(std::move(prepared.document)),
      m_executors(Executor(m_document.drawn_look(), std::move(programs))),
      m_player(std::make_unique<Player>(nullptr, prepared.sender_seconds)),
      m_size(size),
      m_fps(fps),
      m_script{AutomationReader(std::move(prepared.automation)), std::move(prepared.cues),
               std::move(prepared.joined), 0.0, prepared.draws_subframes} {}

Result<Offline> Offline::create(PreparedLook prepared, Extent size, double fps) {
    auto context = gpu::create_headless_context();
    if (!context)
        return fail(context.error());
    if (auto done = apply_constants(prepared.document); !done)
        return fail(done.error());
    const Look look = prepared.document.drawn_look();
    auto programs = build_programs(look, nullptr, prepared.shader_cache.get(), prepared.progress);
    if (!programs)
        return fail(programs.error());
    const auto displayed = prepared.displayed;
    PassSwitches switches = known_switches(look, prepared.switches);
    switches.frozen.clear();
    const std::int64_t start_frame = prepared.start_frame;
    const auto hdr = prepared.hdr;
    Offline offline(std::move(*context), std::move(prepared), std::move(*programs), size, fps);
    offline.m_executors.inputs().hdr = hdr;
    offline.take_values();  // first, because sizes can depend on them
    if (displayed)
        if (auto done = offline.show_to(offline.displayed_with_picture(*displayed)); !done)
            return fail(done.error());
    if (auto done = offline.m_executors.picture().set_runs(runs_of(look, switches)); !done)
        return fail(done.error());
    if (auto done = offline.m_executors.picture().resize(size, size); !done)
        return fail(done.error());
    if (auto done = offline.set_nan_policy(NanPolicy::clamp); !done)
        return fail(done.error());
    if (auto done = offline.load_signal(); !done)
        return fail(done.error());
    if (auto done = offline.load_pictures(); !done)
        return fail(done.error());
    if (start_frame > 0)
        offline.skip_to(start_frame);
    return offline;
}

void Offline::skip_to(std::int64_t frame) {
    const int subframes =
        m_script.draws_subframes ? subframes_of(executor().look(), m_document.values()) : 1;
    m_player->skip_to(frame / subframes * subframes, subframes);
}

void Offline::take_values() {
    m_executors.picture().set_values(m_document.values());
}

Result<void> Offline::load_signal() {
    const Spec& signal = m_document.state().signal;
    if (executor().look().driven_by != Driver::signal)
        return {};
    SignalFile sound{.file = file_of(signal), .sound = {}};
    if (m_script.joined) {
        sound.sound = std::exchange(m_script.joined, nullptr);
    } else if (!sound.file.empty()) {
        auto loaded = load_signal_media(sound.file, nullptr, &m_problems);
        if (!loaded)
            return fail(loaded.error());
        sound.sound = std::move(loaded->sound);
        sound.scene = std::move(loaded->scene);
        sound.drawing = std::move(loaded->drawing);
    }
    add_new(m_problems, notes_about(signal));
    auto set = m_player->set_signal(signal, std::move(sound));
    m_executors.inputs().beam_fit = beam_fit_of(signal);
    m_executors.inputs().sound = m_player->signal().sound_texels();
    return set;
}

namespace {
bool reads_source(const Look& look, const std::vector<bool>& passes) {
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        for (const Input& input : look.passes[i].inputs)
            if (input.from == Input::From::source && (passes[i] || input.frames_ago > 0))
                return true;
    return false;
}
}  // namespace

Result<void> Offline::show_source(double seconds) {
    if (!m_source)
        return {};
    m_source->expect(executor().look().source_encoding);
    SharedPicture picture = m_source->wait_for(seconds);
    if (picture == m_shown)
        return {};
    m_shown = std::move(picture);
    return show_placed(*m_shown, m_source->spec(), m_size, m_executors);
}

Diagnostics Offline::take_problems() {
    Diagnostics problems = std::exchange(m_problems, {});
    if (m_source) {
        const Diagnostics more = m_source->take_problems();
        problems.insert(problems.end(), more.begin(), more.end());
    }
    if (const auto trip = m_nan_watch->take(executor(), true)) {
        problems.push_back(diagnostic_of(*trip, executor().look()));
        std::string& message = problems.back().message;
        message = with_sentence(message, "NaN and Inf were clamped.");
    }
    add_new(problems, m_chosen_images.problems());
    if (const BeamFeed* feed = m_player->signal().feed()) {
        const Diagnostics sent = feed->problems();
        problems.insert(problems.end(), sent.begin(), sent.end());
    }
    return problems;
}

Result<void> Offline::load_pictures() {
    const Look& look = executor().look();
    if (look.driven_by == Driver::picture) {
        auto source = Source::open(m_document.state().source);
        if (!source)
            return fail(source.error());
        m_source = std::move(*source);
        m_source_is_carried = reads_source(look, feedback_passes(look));
        const Extent extent = placed_extent(m_source->extent(), m_source->spec(), m_size);
        if (auto done = m_executors.picture().resize(m_size, extent); !done)
            return done;
        if (auto done = show_source(0.0); !done)
            return done;
    }
    ImageBudget budget;
    for (const Image& image : look.images) {
        const auto picture = load_image(image, m_problems);
        if (!picture)
            return fail(picture.error());
        if (!*picture)
            continue;
        if (auto fits = budget.take(image, **picture); !fits)
            return fits;
        if (auto done = m_executors.picture().set_image(image.name, **picture); !done)
            return done;
    }
    return m_chosen_images.show(look, m_document.values(), m_executors.picture());
}

// Rebuilds the programs after changes of constants or of the driver. Unchanged programs are kept.
Result<void> Offline::follow_constants() {
    if (auto done = apply_constants(m_document); !done)
        return done;
    if (executor().look().constants == m_document.look().constants &&
        executor().look().driven_by == m_document.look().driven_by)
        return {};
    const Look look = m_document.drawn_look();
    auto programs = build_programs(look, &executor().programs().generic());
    return programs ? m_executors.picture().replace(look, *programs)
                    : fail(std::move(programs.error()));
}

bool Offline::is_animated(const Parameter& parameter) const {
    return m_script.automation.has(parameter.name) ||
           m_document.state().modulations.contains(parameter.name) ||
           m_script.cues.changes(parameter.name);
}

Result<void> Offline::specialize(const std::vector<std::string>& displayed,
                                 const std::set<std::string>& moving) {
    if (!moving.empty()) {
        specialize_except(moving);
        return {};
    }
    const Look look = executor().look();
    // Specialised programs contain constants and sizes.
    const bool changes_constants =
        std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
            return is_animated(parameter) &&
                   (parameter.is_constant || drives_size(look, parameter));
        });
    if (changes_constants || m_generic)
        return {};
    const std::vector<bool> is_displayed = displayed_with_picture(displayed);
    if (auto done = show_to(is_displayed); !done)
        return done;
    SpecializedTexts texts;
    const auto programs = build_programs(specialized_look(
        look, m_document.values(), executor().plan(),
        [&](const Parameter& parameter) { return is_animated(parameter); }, texts));
    if (!programs)  // the driver refused: keep the generic programs
        return m_executors.picture().set_displayed({});
    m_generic = executor().programs().generic();
    if (auto done = m_executors.picture().replace(look, *programs); !done)
        return done;
    std::vector<PassRun> runs;
    for (const bool is_read : read_dependencies_of(executor(), is_displayed))
        runs.push_back(is_read ? PassRun::drawn : PassRun::left_out);
    return m_executors.picture().set_runs(runs);
}

void Offline::specialize_except(const std::set<std::string>& moving) {
    const Look& look = executor().look();
    const auto stays = [&](const Parameter& parameter) {
        return moving.contains(parameter.name) || is_animated(parameter);
    };
    if (m_generic || std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
            return stays(parameter) && (parameter.is_constant || drives_size(look, parameter));
        }))
        return;
    SpecializedTexts texts;
    auto programs = build_programs(
        specialized_look(look, m_document.values(), executor().plan(), stays, texts));
    if (programs)
        m_executors.picture().specialize(std::move(*programs), moving);
}

std::vector<bool> Offline::displayed_with_picture(const std::vector<std::string>& names) const {
    std::vector<bool> displayed;
    for (const Pass& pass : executor().look().passes)
        displayed.push_back(std::ranges::find(names, pass.name) != names.end());
    displayed.back() = true;
    return displayed;
}

Result<void> Offline::show_to(const std::vector<bool>& displayed) {
    if (turns_sharing())
        return {};
    return m_executors.picture().set_displayed(displayed, Redraws::never);
}

// Specialised programs support only one plan.
bool Offline::turns_sharing() const {
    const Look& look = executor().look();
    return std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
        return is_animated(parameter) && affects_aliasing(look, parameter);
    });
}

Result<void> Offline::end_specialized() {
    if (!m_generic)
        return {};
    if (auto done = m_executors.picture().set_displayed({}); !done)
        return done;
    const Programs programs = *std::exchange(m_generic, std::nullopt);
    if (auto done = m_executors.picture().replace(executor().look(), programs); !done)
        return done;
    return m_executors.picture().set_runs({});
}

Result<void> Offline::start_again(Document document, std::optional<double> fps) {
    m_fps = fps.value_or(m_fps);
    const DocumentState before = m_document.state();
    const Driver driver = executor().look().driven_by;
    m_document = std::move(document);
    if (auto done = end_specialized(); !done)
        return done;
    if (auto done = follow_constants(); !done)
        return done;
    m_script.automation.start_again();
    take_values();
    m_executors.picture().clear_history();
    if (auto done = resize_again(); !done)
        return done;
    const DocumentState& now = m_document.state();
    const bool changes_driver = executor().look().driven_by != driver;
    if (now.signal == before.signal && !changes_driver) {
        m_player->restart();
    } else {
        m_player = std::make_unique<Player>();
        if (auto done = load_signal(); !done)
            return done;
    }
    if (now.source != before.source || changes_driver)
        return load_pictures();
    return m_chosen_images.show(executor().look(), now.values, m_executors.picture());
}

// The values also go into the document, because pictures are saved with it as a preset.
void Offline::apply_automation(double seconds) {
    const Values changed = m_script.automation.take(seconds);
    if (changed.empty())
        return;
    set_values(m_document, changed, "Automation");
    forget_past(m_document);
    if (auto done = follow_constants(); !done)
        m_problems.insert(m_problems.end(), done.error().begin(), done.error().end());
    take_values();
    if (auto sized = resize_again(); !sized)
        m_problems.insert(m_problems.end(), sized.error().begin(), sized.error().end());
}

Beam Offline::beam_of(const PlayedFrame& frame) const {
    return m_beam ? m_beam(frame) : m_player->signal().trace(frame.span);
}

Result<void> Offline::override_source(const Picture& picture) {
    m_source.reset();
    return m_executors.set_source(picture);
}

void Offline::follow_source(const PlayedFrame& frame) {
    if (!frame.subframe.is_first())
        return;
    if (auto shown = show_source(frame.span.end); !shown)
        m_problems.insert(m_problems.end(), shown.error().begin(), shown.error().end());
}

PlayedFrame Offline::next_frame() {
    const FrameGraph& graph = executor().graph();
    return m_player->advance_fixed(
        m_fps, m_script.draws_subframes ? subframes_of(graph.look(), graph.values()) : 1);
}

void Offline::advance() {
    const PlayedFrame frame = next_frame();
    apply_automation(frame.span.end);
    follow_source(frame);
    modulate_values(frame);
    m_executors.draw(frame, beam_of(frame));
}

Picture Offline::picture_after(int frames) {
    for (int frame = 1; frame < frames; ++frame)
        advance_unseen();
    advance();
    return picture();
}

void Offline::advance_unseen() {
    const PlayedFrame frame = next_frame();
    apply_automation(frame.span.end);
    if (m_source_is_carried || m_script.draws_subframes)
        follow_source(frame);
    modulate_values(frame);
    ::draw_unseen(m_executors, frame, beam_of(frame));
}

Document Offline::drawn_document() const {
    Document document = m_document;
    apply_cues(document, m_script.cues, m_script.position);
    return document;
}

Result<void> Offline::resize_again() {
    const FrameSettings& settings = executor().graph().settings();
    return m_executors.picture().resize(settings.viewport, settings.source);
}

void Offline::modulate_values(const PlayedFrame& frame) {
    const Values& values = m_document.values();
    const DocumentState& state = m_document.state();
    const CuedFrame cued(&m_script.cues, frame.span, played_part(m_player->signal()));
    if (cued.restarts())
        m_executors.picture().clear_history();
    cued.apply_blackout(m_executors);
    m_script.position = cued.position();
    if (auto done =
            modulate(m_executors,
                     {values, values, state.modulations, state.tempo, cued.plan(), cued.position()},
                     frame.span.end, m_player->signal().loudness().get());
        !done)
        m_problems.insert(m_problems.end(), done.error().begin(), done.error().end());
}

// Only the picture, not the passes before it.
bool Offline::is_black(int pass) const {
    return m_executors.inputs().is_black &&
           pass + 1 == static_cast<int>(executor().look().passes.size());
}

Picture Offline::picture(int pass) const {
    if (pass < 0)
        pass = static_cast<int>(executor().look().passes.size()) - 1;
    Picture picture = gpu::read_picture(executor().target(pass));
    picture.encoding = encoding_of(executor().look(), pass);
    if (is_black(pass))
        blacken(picture);
    return picture;
}

void Offline::read(int pass, RawPicture& raw) const {
    gpu::read_raw(executor().target(pass), raw);
    raw.encoding = encoding_of(executor().look(), pass);
    if (is_black(pass))
        blacken(raw);
}
