#pragma once

#include "lab/rendering/renderer.h"

#include <filesystem>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The pictures that a person chose for samplers of the look, as the renderer has them. A file is
/// read when it was chosen or has changed, and not with every edit of the look.
class ChosenImages {
public:
    /// How files are read: before show() returns, or on threads beside who calls it, where the
    /// renderer has been shown something already. Then take_read() shows them.
    enum class Reading { at_once, beside };

    /// Brings the renderer to what the values choose. A sampler without a choice reads its
    /// stand-in; one without that whose choice is taken back, or one whose choice cannot be read,
    /// black. Errors: of the files that were tried now.
    Result<void> show(const Look& look, const Values& values, Renderer& renderer,
                      Renderer::Whose whose = Renderer::Whose::picture,
                      Reading reading = Reading::at_once);
    /// Shows what has been read beside and is still chosen, black where that failed; gives the
    /// samplers' parameters.
    std::vector<std::string> take_read(const Look& look, Renderer& renderer, Diagnostics& problems);
    /// A picture that the user picked for a sampler's parameter.
    struct Choice {
        std::string parameter;
        std::filesystem::path file;
    };
    /// Reads what was picked on another thread. Until it has been read nothing changes.
    void choose(const Look& look, const Choice& choice);
    /// What was picked, once it can be shown. An error names the file. None: nothing is new.
    std::optional<Result<Choice>> take_chosen();
    /// Something that is chosen is being read.
    bool is_reading() const;
    /// The renderer is another, or reads pictures in another way.
    void forget();
    /// The file has changed, whatever its time says; true when a sampler reads it.
    bool forget(const std::filesystem::path& file);
    /// All that are chosen, there or not.
    std::vector<std::filesystem::path> files() const;
    /// What is wrong with them, for as long as they are chosen. Warnings: the look itself runs.
    Diagnostics problems() const;

private:
    struct Shown {
        std::filesystem::path file;
        std::optional<std::filesystem::file_time_type> written;
        Diagnostics problems;
    };
    struct Read {
        std::string parameter;  // "": another has been chosen since
        std::filesystem::path file;
        std::future<Result<Picture>> picture;
    };

    void read_beside(const Look& look, const Parameter& parameter,
                     const std::filesystem::path& file);
    void drop_reading(const std::string& parameter);

    std::map<std::string, Shown> m_shown;  // by the sampler's parameter
    std::vector<Read> m_reading;
    std::optional<Read> m_chosen;  // picked, and not the document's yet
    bool m_has_shown = false;      // since the renderer is this one
};
