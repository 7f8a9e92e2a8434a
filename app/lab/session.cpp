#include "lab/session.h"

#include "base/file.h"
#include "io/files/atomic_file.h"
#include "lab/document/content_edits.h"
#include "lab/document/opened_preset.h"
#include "lab/offline/thumbnail.h"
#include "lab/storage/instance_lock.h"
#include "model/look/stack_size.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace {
fs::path session_file(const Roots& roots) {
    return roots.state / instance_file_name("session", roots.instance);
}

// The presets that states of the history are based on, as indices of the document's and of the
// session's list. The first one is that of the current state.
class SessionOrigins {
public:
    explicit SessionOrigins(const Document& document) {
        add(document.state());
        for (const auto* steps : {&document.history().past(), &document.history().future()})
            for (const auto& step : *steps)
                add(step.state);
    }
    const std::vector<std::size_t>& all() const { return m_all; }
    std::size_t index_of(const DocumentState& state) const {
        return static_cast<std::size_t>(std::ranges::find(m_all, state.origin) - m_all.begin());
    }

private:
    void add(const DocumentState& state) {
        if (std::ranges::find(m_all, state.origin) == m_all.end())
            m_all.push_back(state.origin);
    }

    std::vector<std::size_t> m_all;
};

SessionState session_state(const DocumentState& state, const Look& look, std::string step) {
    SessionState saved{std::move(step), {}, state.overrides};
    saved.preset.look = state.stack.empty() ? look.id : stack_id(state.stack);
    saved.preset.bypass = bypassed_keys(state.stack);
    saved.preset.values = state.values;
    saved.preset.modulations = state.modulations;
    if (state.tempo != Tempo{})
        saved.preset.tempo = state.tempo;
    if (!state.signal.kind.empty())
        saved.preset.signal = state.signal;
    saved.preset.source = state.source;
    saved.is_picture_driven = is_picture_driven(state.stack);
    saved.locks = state.locks;
    saved.cues = state.cues;
    return saved;
}

using LookPaths = std::map<std::string, std::string>;

// The looks of a state; empty if the session lacks the location of one of them.
Stack stack_in(const SessionState& state, const LookPaths& paths) {
    const Preset& preset = state.preset;
    Stack stack;
    if (!fault_of_stack_size(preset.look).empty())
        return stack;
    for (const std::string& id : look_ids(preset.look)) {
        const auto found = paths.find(id);
        if (found == paths.end())
            return {};
        stack.push_back({id, found->second, free_tag(stack, id)});
    }
    stack = with_picture_driven(std::move(stack), state.is_picture_driven);
    return with_bypass(std::move(stack), preset.bypass);
}

// The open look and the locations of the session's looks.
struct Ground {
    const Look& look;
    const LookPaths& paths;
};

DocumentState document_state(const SessionState& saved, const Ground& ground) {
    const Look& look = ground.look;
    DocumentState state = initial_state(look);
    if (Stack stack = stack_in(saved, ground.paths); !stack.empty())
        state.stack = std::move(stack);
    state.values = saved.preset.values;
    if (stack_id(state.stack) == look.id) {
        state.values = changed_values(look, renamed_values(look, state.values));
        for (auto& [name, value] : state.values)
            if (const Parameter* parameter = find_parameter(look, name))
                value = clamped(*parameter, value);
    }
    if (saved.preset.signal)
        state.signal = *saved.preset.signal;
    if (!saved.preset.source.empty())
        state.source = saved.preset.source;
    state.overrides = saved.overrides;
    state.modulations = saved.preset.modulations;
    state.tempo = saved.preset.tempo.value_or(Tempo{});
    state.locks = saved.locks;
    state.cues = saved.cues;
    state.origin = saved.opened;
    return state;
}

using HistorySteps = std::vector<Undo<DocumentState>::Step>;

std::vector<SessionState> session_states(const HistorySteps& steps, const Look& look,
                                         const SessionOrigins& origins) {
    std::vector<SessionState> states;
    for (const auto& step : steps) {
        states.push_back(session_state(step.state, look, step.name));
        states.back().chose_content = step.is_marked;
        states.back().opened = origins.index_of(step.state);
    }
    return states;
}

std::vector<SessionPreset> session_presets(const Document& document,
                                           const SessionOrigins& origins) {
    std::vector<SessionPreset> presets;
    for (const std::size_t origin : origins.all()) {
        const OpenedPreset& opened = document.opened_presets()[origin];
        SessionState saved = session_state(opened.saved, document.look(), {});
        saved.preset.name = opened.identity.name;
        saved.preset.about = opened.identity.about;
        saved.preset.author = opened.identity.author;
        presets.push_back({opened.file.string(), std::move(saved)});
    }
    return presets;
}

HistorySteps document_steps(const std::vector<SessionState>& states, const Ground& ground) {
    HistorySteps steps;
    for (const SessionState& state : states)
        steps.push_back({document_state(state, ground), state.step, state.chose_content});
    return steps;
}

void restore_document(Document& document, const Session& session) {
    const Look look = document.look();
    const Ground ground{look, session.looks};
    std::vector<OpenedPreset> presets;
    for (const SessionPreset& opened : session.opened) {
        presets.push_back({opened.saved.preset, opened.file, document_state(opened.saved, ground)});
        presets.back().saved.origin = presets.size() - 1;
    }
    document.replace_history(Undo<DocumentState>::restored(document_steps(session.past, ground),
                                                           document_state(session.current, ground),
                                                           document_steps(session.future, ground)),
                             std::move(presets));
}

void note_paths(const DocumentState& state, LookPaths& paths) {
    for (const StackPart& part : state.stack)
        paths[part.look] = part.path.string();
}

LookPaths paths_of(const Document& document) {
    LookPaths paths;
    const SessionOrigins origins(document);
    for (const std::size_t origin : origins.all())
        note_paths(document.opened_presets()[origin].saved, paths);
    for (const auto* steps : {&document.history().past(), &document.history().future()})
        for (const auto& step : *steps)
            note_paths(step.state, paths);
    note_paths(document.state(), paths);
    return paths;
}
}  // namespace

namespace {
Session load_file(const fs::path& file, Diagnostics& warnings) {
    std::error_code error;
    if (!fs::exists(file, error))
        return {};
    const auto text = read_text(file);
    auto session = text ? parse_session(*text, file) : fail(text.error());
    if (session)
        return std::move(*session);
    const fs::path aside = file.string() + ".damaged";
    fs::rename(file, aside, error);
    warnings.push_back(session.error().front());
    warnings.push_back({aside, 0, "is a copy of the damaged session file", Severity::warning});
    return {};
}
}  // namespace

Content content_of(const Session& session) {
    const SessionState& state = session.current;
    return {state.preset.signal.value_or(Spec{}), state.preset.source, state.locks};
}

Session load_session(const Roots& roots, Diagnostics& warnings) {
    const fs::path file = session_file(roots);
    std::error_code error;
    if (roots.instance <= 1 || fs::exists(file, error))
        return load_file(file, warnings);
    // Another window starts as the first one last was.
    const fs::path first = session_file(first_instance(roots));
    const auto text = read_text(first);
    auto session = text ? parse_session(*text, first) : fail(text.error());
    return session ? std::move(*session) : Session{};
}

Result<void> save_session(const Roots& roots, const Session& session) {
    return write_atomically(session_file(roots), session_to_json(session));
}

Session session_of(const Lab& lab, std::map<std::string, double> window) {
    Session session;
    session.window = std::move(window);
    const PictureSize& size = lab.work().size.chosen();
    session.follows_view = size.follows_view;
    session.fixed_size = size.fixed;
    session.fits_shape = size.fits_shape;
    session.picture_scale = size.scale;
    session.picture_shape = size.shape ? std::string(shape_name(*size.shape)) : std::string();
    const Transport& transport = lab.player().transport();
    session.time = transport.time();
    session.speed = transport.speed();
    session.level = lab.player().devices().level();
    session.is_playing = transport.is_playing();
    session.comparison = lab.frames().comparison().selection().chosen();
    session.slots = lab.frames().comparison().selection().all_slots();
    session.parameter_settings = lab.parameters().all();
    session.preset_stars = lab.presets().navigation().stars();
    const Document* document = lab.document();
    if (!document)
        return session;
    const Look& look = document->look();
    session.look = look.manifest.string();
    session.looks = paths_of(*document);
    const SessionOrigins origins(*document);
    session.opened = session_presets(*document, origins);
    session.current = session_state(document->state(), look, {});
    session.past = session_states(document->history().past(), look, origins);
    session.future = session_states(document->history().future(), look, origins);
    return session;
}

namespace {
// Restores the paused picture with its afterglow.
void rest_at(double seconds, Lab& lab) {
    Player& player = lab.player();
    const int settling = lab.document()->look().settle_frames;
    player.pause();
    player.seek_with_past(seconds, static_cast<std::size_t>(std::max(settling, 1)));
    if (player.transport().past().empty())
        player.step();
}
}  // namespace

namespace {
// Content that is locked now stays when unsaved changes are restored.
void keep_locked(const Content& current, Document& document) {
    Content content = content_of(document);
    if (current.locks.signal)
        content.signal = current.signal;
    if (current.locks.source)
        content.source = current.source;
    content.locks.signal |= current.locks.signal;
    content.locks.source |= current.locks.source;
    keep_content(document, content);
}
}  // namespace

void restore(Lab& lab, const Session& session, const std::function<void(Lab&)>& then) {
    lab.work().size.choose({session.follows_view, session.fixed_size, session.picture_scale,
                            find_shape(session.picture_shape), session.fits_shape});
    lab.player().set_speed(session.speed);
    lab.player().set_level(session.level);
    if (session.look.empty())
        return;
    if (const PlayedSignal& signal = lab.player().signal(); !signal.live_input().is_open())
        (void)lab.player().mute_input(true);  // the user has not enabled it yet
    const Content current = lab.document() ? content_of(*lab.document()) : Content{};
    const CueText cues = lab.document() ? lab.document()->state().cues : CueText{};
    const auto restore_rest = [&lab, session, then, current, cues] {
        Document& document = *lab.work().document;
        restore_document(document, session);
        if (!cues.is_empty())  // they stay when unsaved changes are restored, as with another look
            document.amend([&](DocumentState& state) { state.cues = cues; }, AmendedStates::all);
        keep_locked(current, document);
        if (session.is_playing)
            lab.player().seek(session.time);
        else
            rest_at(session.time, lab);
        lab.frames().comparison().choose(session.comparison);
        if (then)
            then(lab);
    };
    lab.loader().open({session.look,
                       {},
                       {},
                       stack_in(session.current, session.looks),
                       session.current.preset.values},
                      restore_rest);
}

void restore_stashed(Lab& lab, const fs::path& file) {
    const auto session = SessionStash::read(file);
    if (!lab.messages().succeeded(session))
        return;
    // Opening stores unsaved changes of another look.
    if (lab.document() && lab.document()->look().manifest == session->look)
        lab.looks().stash_unsaved(session_of(lab, {}),
                                  [&lab] { return small_copy(lab.renderer()); });
    restore(lab, *session, [file](Lab& opened) { opened.looks().stash().forget(file); });
}
