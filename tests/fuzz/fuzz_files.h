#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A folder in memory that holds the files of one run; gone when the program ends.
class FuzzFolder {
public:
    /// `names` are the files' paths below the folder, in the order in which runs fill them.
    explicit FuzzFolder(std::vector<std::string> names);
    ~FuzzFolder();
    FuzzFolder(const FuzzFolder&) = delete;
    FuzzFolder& operator=(const FuzzFolder&) = delete;

    /// Writes the pieces of `input`, between form feeds, to the files; those for which there is no
    /// piece are removed.
    void fill(std::string_view input);

    /// The path of a file by its place.
    std::filesystem::path file(std::size_t index) const { return m_folder / m_names[index]; }

private:
    std::filesystem::path m_folder;
    std::vector<std::string> m_names;
    std::vector<std::string> m_texts;  // as they are on the disk
    std::vector<bool> m_is_there;
};

/// What a program does with one random text; each program has its own.
void fuzz_one(std::string_view input);

/// Ends the program, and so shows the run, where a rule is broken.
void require(bool is_kept, const char* rule);

/// What is refused says why, and in which file.
void require_reasons(const Diagnostics& errors);

/// Every line of a stage knows where it was written.
void require_places(const Stage& stage);
