#pragma once

#include "lab/renderer.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The pictures that a person chose for samplers of the look, as the renderer has them. A file is
/// read when it was chosen or has changed, and not with every edit of the look.
class ChosenImages {
public:
    /// Brings the renderer to what the values choose. A sampler without a choice reads its
    /// stand-in; one without that whose choice is taken back, or one whose choice cannot be read,
    /// black. Errors: of the files that were tried now.
    Result<void> show(const Look& look, const Values& values, Renderer& renderer,
                      Renderer::Whose whose = Renderer::Whose::picture);
    /// The renderer is another, or reads pictures in another way.
    void forget() { m_shown.clear(); }
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

    std::map<std::string, Shown> m_shown;  // by the sampler's parameter
};
