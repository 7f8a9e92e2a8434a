#pragma once

#include "lab/document/document.h"
#include "lab/media/media_loader.h"
#include "lab/playback/player.h"
#include "lab/rendering/renderer.h"
#include "lab/storage/media.h"

#include <memory>
#include <optional>
#include <string>

/// The file that drives the open look, as the document names it; "" for none. A pattern's name is
/// no file's.
std::string driving_file(const Document& document);

/// A signal or source that the user chose, with the file that it is read from.
struct ChosenContent {
    Driver driver = Driver::signal;  // which of both
    Spec signal = {};
    std::string source = {};
    std::filesystem::path file = {};
};

/// Brings what drives the open look to where it is used: the signal to the player, the source
/// picture to the renderer. Files are read on another thread; until then the last one goes on.
class Drive {
public:
    explicit Drive(RecentMedia recent) : m_recent(std::move(recent)) {}

    const RecentMedia& recent() const { return m_recent; }

    /// Another look was opened: its renderer has no source yet, and no file is awaited for it.
    void forget();
    /// Follows the document's signal or source. An error says why it cannot; then the look's own
    /// goes on if nothing did before.
    Result<void> follow(const Document& document, Player& player, Renderer& renderer);
    /// Reads the file of what the user chose. Until it has been read nothing changes.
    void choose(ChosenContent chosen);
    /// What was chosen, once its file has been read and can be shown: the player has the sound, or
    /// source() is the picture. An error names the file, and nothing has changed. None: nothing is
    /// new.
    std::optional<Result<ChosenContent>> take_chosen(const Look& look, Player& player);

    /// Takes in what has been read; nothing when there is nothing new.
    std::optional<Result<void>> update(const Document& document, Player& player,
                                       Renderer& renderer);

    /// The file was changed on disk: it is read again, and the last one goes on until it is there.
    void read_again(const Document& document);

    /// The file that is being read; "" for none.
    std::string loading() const;
    double loaded_share() const;
    void cancel();

    /// What is wrong with the file that the document names, for as long as it names it: it is
    /// missing, cannot be read or breaks off. Warnings: the look itself runs.
    const Diagnostics& problems() const { return m_problems; }

    /// The size that the look draws, in which the source lies.
    void set_viewport(Extent viewport) { m_viewport = viewport; }
    /// Of the source as the look reads it; empty when there is none.
    Extent source_extent() const;
    /// Gives the renderer the source as it is at a frame's end; true when it was another picture
    /// than before. One that is still being read is late.
    Result<bool> show_source(double seconds, Renderer& renderer);
    /// The same for a frame of the past that is drawn again. A film stays at its present picture.
    Result<void> show_past_source(double seconds, Renderer& renderer);
    /// The same to a renderer that has lost it.
    Result<void> show_anew(const Player& player, Renderer& renderer);
    /// A renderer beside the one that is shown: how large its picture is, and what it has so far.
    struct Beside {
        Renderer& renderer;
        Extent viewport;
        SharedPicture& shown;
    };
    Extent source_extent(Extent viewport) const;
    /// As show_source and show_past_source.
    Result<void> show_beside(double seconds, const Beside& beside);
    Result<void> show_past_beside(double seconds, const Beside& beside);
    bool is_source_late() const { return m_source && m_source->is_late(); }
    const std::optional<Source>& source() const { return m_source; }
    /// What of the source could not be read since last asked; problems() keeps it.
    Diagnostics take_problems();

private:
    Result<void> follow_signal(const Document& document, Player& player);
    Result<void> follow_source(const Document& document, const Player& player, Renderer& renderer);
    Result<void> take(LoadedMedia loaded, const Document& document, Player& player,
                      Renderer& renderer);
    Result<void> fall_back(const Document& document, Player& player, Diagnostics reasons) const;

    void note(const std::string& file, Diagnostics problems);

    RecentMedia m_recent;
    std::string m_problem_file;
    Diagnostics m_problems;
    MediaLoader m_loader;  // of what the document names
    std::optional<ChosenContent> m_chosen;
    MediaLoader m_chosen_loader;
    std::optional<Source> m_source;
    Extent m_viewport;
    SharedPicture m_shown;  // what the renderer has, and how it lies there
    Extent m_shown_extent;
};
