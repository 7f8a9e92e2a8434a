#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A folder in memory with the files of one run. It is deleted at the end of the program.
class FuzzFolder {
public:
    /// `names` are the paths of the files in the folder, in the order of the pieces of an input.
    explicit FuzzFolder(std::vector<std::string> names);
    ~FuzzFolder();
    FuzzFolder(const FuzzFolder&) = delete;
    FuzzFolder& operator=(const FuzzFolder&) = delete;

    /// Splits `input` at form feeds and writes the pieces to the files. Files without a piece are
    /// deleted.
    void fill(std::string_view input);

    /// Writes one file, with any bytes.
    void write(std::size_t index, std::string_view bytes);

    /// The path of the file with this index.
    std::filesystem::path file(std::size_t index) const { return m_folder / m_names[index]; }

private:
    std::filesystem::path m_folder;
    std::vector<std::string> m_names;
    std::vector<std::string> m_texts;  // the content on disk
    std::vector<bool> m_is_there;
};

/// Processes one random text. Each fuzz program defines it.
void fuzz_one(std::string_view input);

/// Aborts if a rule is broken, so that the fuzzer records the run.
void require(bool is_kept, const char* rule);

/// Requires a reason and a file in each error.
void require_reasons(const Diagnostics& errors);

/// The same for readers of texts that have no file.
void require_messages(const Diagnostics& errors);

/// Requires an origin for every line of a stage.
void require_locations(const Stage& stage);

/// Requires that what `read` accepts is written by `written` so that it reads the same.
template <class Read, class Written>
void require_round_trip(std::string_view text, const Read& read, const Written& written) {
    const auto first = read(text, "first.txt");
    if (!first)
        return require_reasons(first.error());
    const std::string once = written(*first);
    const auto again = read(once, "again.txt");
    require(again.has_value(), "what was written can be read");
    require(written(*again) == once, "what was read stays the same");
}
