#pragma once

#include "base/diagnostic.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

/// The text of one file of shader code and what its directives ask for.
struct ShaderText {
    struct Include {
        std::size_t begin = 0;  // in the text, with the '#'; end: behind its last argument
        std::size_t end = 0;
        int line = 1;
        int last_line = 1;
        std::optional<std::string> file;   // of #include "file"
        std::optional<std::string> given;  // of #include <given>
    };

    std::string text;  // LF alone ends lines; `#line` and `#pragma once` are blank
    std::vector<Include> includes;
    bool is_once = false;
    int unclosed_comment = 0;     // line where one starts that never ends; 0: none
    std::size_t file_size = 0;    // bytes; a file above most_bytes is told by it and has no text
    std::filesystem::path place;  // as place_of()
};

/// Files of shader code as they lie on the disk. Within one reading of a look each is read once, or
/// not at all where its stamp tells that nobody has written it since the last one. What was found
/// in a text serves the next readings as long as the text is the same. Not thread-safe.
class ShaderFiles {
public:
    static constexpr std::size_t most_bytes = std::size_t{4} << 20;

    /// From here on files may have changed; what the last reading did not ask for is forgotten.
    void begin_reading();

    /// Errors as those of read_text. Valid until the next reading.
    const Result<ShaderText>& read(const std::filesystem::path& file);
    /// The same of another text that a look is made of, into which nobody looks here.
    const Result<std::string>& read_plain(const std::filesystem::path& file);
    /// Of the text that this reading has of the file; nothing where it has not asked for it.
    std::optional<std::size_t> digest_of_read(const std::filesystem::path& file) const;
    bool exists(const std::filesystem::path& file);
    /// Where links lead to; "" for what is missing.
    const std::filesystem::path& place_of(const std::filesystem::path& path);
    /// How many files were read so far.
    int reads() const { return m_reads; }

private:
    /// Of one state of one file.
    struct Stamp {
        std::array<std::uint64_t, 3> what{};  // device, inode, size in bytes
        std::array<std::int64_t, 4> when{};   // text and inode were written: seconds, nanoseconds
        bool operator==(const Stamp&) const = default;
    };
    struct Known {
        Result<std::string> bytes;
        std::size_t digest = 0;                   // of them, or of why there are none
        std::optional<Result<ShaderText>> found;  // in them
        std::optional<Stamp> stamp;   // before they were read; null: it tells too little
        std::filesystem::path place;  // where they were read
        std::uint64_t reading = 0;    // of which they are
        std::uint64_t asked = 0;      // by this reading at last
    };
    using Path = std::filesystem::path::string_type;

    static std::optional<Stamp> stamp_of(const std::filesystem::path& file);
    Known& known(const std::filesystem::path& file);

    std::uint64_t m_reading = 0;
    int m_reads = 0;
    std::unordered_map<Path, Known> m_known;
    std::unordered_map<Path, std::filesystem::path> m_places;  // of this reading; "": nowhere
};
