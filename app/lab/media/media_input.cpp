#include "lab/media/media_input.h"

#include "base/text.h"
#include "signals/signal_table.h"

#include <utility>

namespace {
// Adds a hint for users who opened a preset and do not know its file.
Diagnostics with_hint(Diagnostics reasons) {
    std::error_code error;
    for (Diagnostic& reason : reasons)
        if (!reason.file.empty() && !std::filesystem::exists(reason.file, error))
            reason.message = with_sentence(
                reason.message, "It is neither next to the preset nor among the recent files.");
    return reasons;
}

// The file of a source, without its settings.
std::string file_of_source(const std::string& source) {
    const auto spec = parse_source(source);
    return spec ? spec->picture : source;
}
}  // namespace

std::string driving_file(const Document& document) {
    const bool is_picture = document.look().driven_by == Driver::picture;
    return is_picture ? file_of_source(document.state().source) : file_of(document.state().signal);
}

void MediaInput::forget() {
    m_loader.cancel();
    m_source.set(std::nullopt);
    note({}, {});
}

void MediaInput::note(const std::string& file, Diagnostics problems) {
    m_problem_file = file;
    m_problems = std::move(problems);
    for (Diagnostic& problem : m_problems)
        problem.severity = Severity::warning;
}

Result<void> MediaInput::follow(const Document& document, Player& player, Executors& executors) {
    if (m_problem_file != driving_file(document))
        note(driving_file(document), {});
    switch (document.look().driven_by) {
        case Driver::signal:
            return follow_signal(document, player);
        case Driver::picture:
            if (player.signal().get())
                if (auto silent = player.set_signal({}); !silent)
                    return silent;
            return follow_source(document, player, executors);
        case Driver::nothing:
            break;
    }
    m_loader.cancel();
    return player.set_signal({});
}

Result<void> MediaInput::follow_signal(const Document& document, Player& player) {
    const Spec& spec = document.state().signal;
    const std::string file = file_of(spec);
    const PlayedSignal& played = player.signal();
    if (!file.empty() && file != played.sound().file) {
        if (file != m_loader.name())
            m_loader.load(MediaLoader::Kind::signal, file);
        return played.get() ? Result<void>() : fall_back(document, player, {});
    }
    m_loader.cancel();
    if (auto set = player.set_signal(spec, file.empty() ? SignalFile{} : played.sound()); !set)
        return fall_back(document, player, std::move(set.error()));
    return {};
}

void MediaInput::choose(ChosenContent chosen) {
    const bool is_signal = chosen.driver == Driver::signal;
    m_chosen_loader.load(is_signal ? MediaLoader::Kind::signal : MediaLoader::Kind::source,
                         is_signal ? file_of(chosen.signal) : chosen.source);
    m_chosen = std::move(chosen);
}

std::optional<Result<ChosenContent>> MediaInput::take_chosen(const Look& look, Player& player) {
    auto loaded = m_chosen_loader.take_finished();
    if (!loaded || !m_chosen)
        return std::nullopt;
    const ChosenContent chosen = *std::exchange(m_chosen, std::nullopt);
    if (!loaded->problems.empty())
        return fail(std::move(loaded->problems));
    const bool is_shown =
        look.driven_by == chosen.driver;  // otherwise another look has been opened
    if (is_shown && loaded->source)
        m_source.set(std::move(loaded->source));
    else if (is_shown)
        if (auto set = player.set_signal(
                chosen.signal, {loaded->name, loaded->sound, loaded->scene, loaded->drawing});
            !set)
            return fail(std::move(set.error()));
    if (is_shown)
        m_loader.cancel();
    m_recent.remember(
        chosen.file.empty() ? std::filesystem::path(file_of_source(chosen.source)) : chosen.file,
        loaded->digest);
    if (is_shown)
        note(chosen.driver == Driver::signal ? file_of(chosen.signal)
                                             : file_of_source(chosen.source),
             std::move(loaded->notes));
    return chosen;
}

std::string MediaInput::loading() const {
    return m_chosen ? m_chosen_loader.name() : m_loader.name();
}

double MediaInput::loaded_share() const {
    return m_chosen ? m_chosen_loader.share() : m_loader.share();
}

void MediaInput::cancel() {
    if (!m_chosen)
        return m_loader.cancel();
    m_chosen_loader.cancel();
    m_chosen.reset();
}

void MediaInput::read_again(const Document& document) {
    if (document.look().driven_by == Driver::picture)
        m_loader.load(MediaLoader::Kind::source, document.state().source);
    else
        m_loader.load(MediaLoader::Kind::signal, file_of(document.state().signal));
}

// Without reasons, the fallback is temporary, while a file is being loaded.
Result<void> MediaInput::fall_back(const Document& document, Player& player,
                                   Diagnostics reasons) const {
    const auto& own = document.look().default_signal;
    // A preset with a missing file opens with the look's own signal. If the user chose an
    // unreadable file, or the file broke on disk, the last signal stays.
    const bool is_as_opened = document.state().signal == opened_preset(document).saved.signal;
    const bool was_read = player.signal().sound().file == file_of(document.state().signal);
    const bool is_needed =
        !player.signal().get() || (is_as_opened && !was_read && !reasons.empty());
    if (is_needed && own && file_of(*own).empty())
        if (const auto set = player.set_signal(*own); !set)
            reasons.insert(reasons.end(), set.error().begin(), set.error().end());
    if (reasons.empty())
        return {};
    return fail(std::move(reasons));
}

Result<void> MediaInput::follow_source(const Document& document, const Player& player,
                                       Executors& executors) {
    const std::string& name = document.state().source;
    const auto spec = parse_source(name);
    if (!spec)
        return fail(spec.error());
    if (Source* source = m_source.get(); source && source->spec().picture == spec->picture) {
        m_loader.cancel();
        source->set_spec(*spec);
        return m_source.show_again(player.transport().time(), executors);
    }
    if (name != m_loader.name())
        m_loader.load(MediaLoader::Kind::source, name);
    return {};
}

std::optional<Diagnostics> MediaInput::take_problems() {
    constexpr std::size_t max_kept = 4;  // fits into a panel
    Source* source = m_source.get();
    if (!source)
        return std::nullopt;
    const bool is_solved = source->take_solved();  // first: a later problem is new
    Diagnostics problems = source->take_problems();
    if (problems.empty() && !is_solved)
        return std::nullopt;
    if (source->is_live() && source->spec().picture == m_problem_file)
        m_problems.clear();  // it has one at most
    for (Diagnostic& problem : problems) {
        problem.severity = Severity::warning;
        if (source->spec().picture == m_problem_file && m_problems.size() < max_kept)
            m_problems.push_back(problem);
    }
    return problems;
}

std::optional<Result<void>> MediaInput::update(const Document& document, Player& player,
                                               Executors& executors) {
    auto loaded = m_loader.take_finished();
    if (!loaded)
        return std::nullopt;
    const bool is_picture = document.look().driven_by == Driver::picture;
    const std::string file = is_picture ? file_of_source(loaded->name) : loaded->name;
    Diagnostics notes = std::move(loaded->notes);
    auto taken = take(std::move(*loaded), document, player, executors);
    if (!taken)
        notes.insert(notes.end(), taken.error().begin(), taken.error().end());
    note(file, std::move(notes));
    if (taken && !m_problems.empty())
        return fail(m_problems);  // reported once; the sound plays as far as it is valid
    return taken;
}

Result<void> MediaInput::take(LoadedMedia loaded, const Document& document, Player& player,
                              Executors& executors) {
    if (!loaded.problems.empty())
        return fall_back(document, player, with_hint(std::move(loaded.problems)));
    const std::string file = loaded.source ? loaded.source->spec().picture : loaded.name;
    if (!loaded.source || !loaded.source->spec().is_pattern())
        m_recent.remember(file, loaded.digest);
    if (loaded.source) {
        m_source.set(std::move(loaded.source));
        if (player.transport().frame_number() > 0)
            return m_source.show_again(player.transport().time(), executors);
        return {};  // the first frame shows its own picture
    }
    if (auto set = player.set_signal(document.state().signal,
                                     {loaded.name, std::move(loaded.sound), std::move(loaded.scene),
                                      std::move(loaded.drawing)});
        !set)
        return fall_back(document, player, std::move(set.error()));
    const std::string& expected = opened_preset(document).identity.media_digest;
    if (document.state().signal == opened_preset(document).saved.signal && !expected.empty() &&
        expected != loaded.digest)
        return fail(other_media(loaded.name));
    return {};
}
