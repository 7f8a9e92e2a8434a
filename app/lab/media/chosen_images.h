#pragma once

#include "graph/executor/executor.h"

#include <filesystem>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The user's pictures for samplers of the look, as uploaded to an executor. A file is only read
/// when it is chosen or changes, not with every edit of the look.
class ChosenImages {
public:
    /// How show() reads files: before it returns, or on background threads for take_read(). The
    /// first call for an executor always reads immediately.
    enum class Reading { at_once, in_background };

    /// Updates the executor to the chosen files. A sampler that was never given a file keeps its
    /// default image. If its file is removed or not readable, it is black. Errors are those of the
    /// files read now.
    Result<void> show(const Look& look, const Values& values, Executor& executor,
                      Reading reading = Reading::at_once);
    /// Uploads pictures read in the background that are still chosen; black if reading failed.
    /// Returns the parameters of their samplers.
    std::vector<std::string> take_read(const Look& look, Executor& executor, Diagnostics& problems);
    /// A picture that the user picked for a sampler's parameter.
    struct ChosenFile {
        std::string parameter;
        std::filesystem::path file;
    };
    /// Reads a picked file on a background thread. Nothing changes until it has been read.
    void choose(const Look& look, const ChosenFile& chosen);
    /// The picked file when it is ready. An error names the file. nullopt: not ready.
    std::optional<Result<ChosenFile>> take_chosen();
    /// Whether a chosen file is being read.
    bool is_reading() const;
    /// Discards all state, for another executor or another way of reading.
    void forget();
    /// Marks a file as changed, regardless of its time; true if a sampler uses it.
    bool forget(const std::filesystem::path& file);
    /// All chosen files, including missing ones.
    std::vector<std::filesystem::path> files() const;
    /// The problems of the chosen files. Warnings, because the look itself runs.
    Diagnostics problems() const;

private:
    struct Shown {
        std::filesystem::path file;
        std::optional<std::filesystem::file_time_type> written;
        Diagnostics problems;
    };
    struct Read {
        std::string parameter;  // "": replaced by another choice
        std::filesystem::path file;
        std::future<Result<Picture>> picture;
    };

    void read_async(const Look& look, const Parameter& parameter,
                    const std::filesystem::path& file);
    void drop_reading(const std::string& parameter);

    std::map<std::string, Shown> m_shown;  // by the sampler's parameter
    std::vector<Read> m_reading;
    std::optional<Read> m_chosen;  // picked, not in the document yet
    bool m_has_shown = false;      // for the current executor
};
