#pragma once

#include "lab/document/document.h"
#include "lab/media/fitted_source.h"
#include "lab/media/media_loader.h"
#include "lab/playback/player.h"
#include "lab/rendering/executors.h"
#include "lab/storage/media.h"

#include <memory>
#include <optional>
#include <string>

/// The file of the document's signal or source; "": no file. For a pattern, its text
/// "pattern:NAME".
std::string driving_file(const Document& document);

/// A signal or source that the user chose, and its file.
struct ChosenContent {
    Driver driver = Driver::signal;  // which of the two
    Spec signal = {};
    std::string source = {};
    std::filesystem::path file = {};  // "": a live source
};

/// Loads the signal or source of the open look: the signal for the player, the source picture for
/// the renderer. A background thread reads the files. Until then the previous content stays.
class MediaInput {
public:
    explicit MediaInput(RecentMedia recent) : m_recent(std::move(recent)) {}

    const RecentMedia& recent() const { return m_recent; }

    /// Resets everything for a newly opened look: no source, no pending file.
    void forget();
    /// Applies the document's signal or source. If it fails, the look's own signal is used if the
    /// player had no signal.
    Result<void> follow(const Document& document, Player& player, Executors& executors);
    /// Reads the file of a user's choice. Nothing changes until it has been read.
    void choose(ChosenContent chosen);
    /// The user's choice when its file has been read. The player then has the sound, or source() is
    /// the picture. An error names the file, and nothing has changed. nullopt: not ready.
    std::optional<Result<ChosenContent>> take_chosen(const Look& look, Player& player);

    /// Applies a file that has been read; nullopt: not ready.
    std::optional<Result<void>> update(const Document& document, Player& player,
                                       Executors& executors);

    /// Reads a changed file again. Until then the previous content stays.
    void read_again(const Document& document);

    /// The file being read; "": not reading.
    std::string loading() const;
    double loaded_share() const;
    void cancel();

    /// The problems of the document's file: missing, unreadable or truncated. Warnings, because the
    /// look itself runs.
    const Diagnostics& problems() const { return m_problems; }

    FittedSource& source() { return m_source; }
    const FittedSource& source() const { return m_source; }
    /// The new read errors of the source since the last call; problems() keeps them. Empty: the
    /// problem of a live source has ended. nullopt: nothing has changed.
    std::optional<Diagnostics> take_problems();

private:
    Result<void> follow_signal(const Document& document, Player& player);
    Result<void> follow_source(const Document& document, const Player& player,
                               Executors& executors);
    Result<void> take(LoadedMedia loaded, const Document& document, Player& player,
                      Executors& executors);
    Result<void> fall_back(const Document& document, Player& player, Diagnostics reasons) const;

    void note(const std::string& file, Diagnostics problems);

    RecentMedia m_recent;
    std::string m_problem_file;
    Diagnostics m_problems;
    MediaLoader m_loader;  // for the document's file
    std::optional<ChosenContent> m_chosen;
    MediaLoader m_chosen_loader;
    FittedSource m_source;
};
