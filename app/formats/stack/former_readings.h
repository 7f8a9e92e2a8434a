#pragma once

#include "formats/look_format.h"

#include <cstddef>
#include <deque>
#include <optional>

/// A cache of recently loaded looks, for files that return to previous content, as with undo.
/// Caches only successful results whose inputs are all known: native looks and single fragment
/// shaders.
class FormerReadings {
public:
    /// The arguments of load_stack().
    struct Question {
        Stack stack;
        Values values;
        bool operator==(const Question&) const = default;
    };

    /// The cached result if all files match this reading of `disk`; nullopt: load them.
    std::optional<LoadedLook> find(const Question& question, ShaderFiles& disk) const;
    /// Adds a result of this reading of `disk`.
    void keep(const Question& question, const LoadedLook& loaded, ShaderFiles& disk);

private:
    struct SeenFile {
        std::filesystem::path file;
        std::filesystem::path place;        // canonical path; "": the file was missing
        std::optional<std::size_t> digest;  // of its text; nullopt: only its existence matters
    };
    struct Reading {
        Question question;
        LoadedLook loaded;
        std::vector<SeenFile> files;
    };

    static std::optional<std::vector<SeenFile>> files_of(const LoadedLook& loaded,
                                                         ShaderFiles& disk);

    std::deque<Reading> m_readings;  // newest first
};
