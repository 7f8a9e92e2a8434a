#pragma once

#include "formats/look_format.h"

#include <cstddef>
#include <deque>
#include <optional>

/// What looks were read as lately, for files that come to say again what they said then, as undo
/// brings them. Only what was good, and only where all that it was made of is known: looks of our
/// own, and fragment shaders alone.
class FormerReadings {
public:
    /// What load_stack is asked for.
    struct Question {
        Stack stack;
        Values values;
        bool operator==(const Question&) const = default;
    };

    /// What came of the question when all files were as this reading of `disk` finds them; nothing:
    /// they are to be read.
    std::optional<LoadedLook> find(const Question& question, ShaderFiles& disk) const;
    /// What has come of the question in this reading of `disk`.
    void keep(const Question& question, const LoadedLook& loaded, ShaderFiles& disk);

private:
    struct SeenFile {
        std::filesystem::path file;
        std::filesystem::path place;        // "": it was missing
        std::optional<std::size_t> digest;  // of its text; nothing: it only has to be there
    };
    struct Reading {
        Question question;
        LoadedLook loaded;
        std::vector<SeenFile> files;
    };

    static std::optional<std::vector<SeenFile>> files_of(const LoadedLook& loaded,
                                                         ShaderFiles& disk);

    std::deque<Reading> m_readings;  // the newest first
};
