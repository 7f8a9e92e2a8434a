#pragma once

#include "base/diagnostic.h"
#include "base/file_stamp.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

/// The text of one shader file and its directives.
struct ShaderText {
    struct Include {
        std::size_t begin = 0;  // offset of the '#'; end: after its last argument
        std::size_t end = 0;
        int line = 1;
        int last_line = 1;
        std::optional<std::string> file;   // of #include "file"
        std::optional<std::string> given;  // of #include <given>
    };

    std::string text;  // LF line ends only; `#line` and `#pragma once` are blanked out
    std::vector<Include> includes;
    bool is_once = false;
    int unclosed_comment = 0;         // line where an unterminated comment starts; 0: none
    std::size_t file_size = 0;        // bytes; a file larger than max_bytes has no text
    std::filesystem::path canonical;  // see canonical_path()
};

/// Shader files on disk. Each file is read at most once per reading of a look, and not at all if
/// its stamp is unchanged. Parsed texts are reused by later readings while the text is the same.
/// Not thread-safe.
class ShaderFiles {
public:
    static constexpr std::size_t max_bytes = std::size_t{4} << 20;

    /// Reads the stamp of a file; nullopt if it is missing.
    using ReadStamp = std::optional<FileStamp> (*)(const std::filesystem::path& file);

    /// Without `read_stamp`, each reading reads its files again.
    explicit ShaderFiles(ReadStamp read_stamp = nullptr) : m_read_stamp(read_stamp) {}

    /// Starts a new reading: files may have changed. Drops files that the last reading did not use.
    void begin_reading();

    /// Errors as for read_text(). Valid until the next reading.
    const Result<ShaderText>& read(const std::filesystem::path& file);
    /// Like read(), for another text of a look, without parsing it.
    const Result<std::string>& read_plain(const std::filesystem::path& file);
    bool exists(const std::filesystem::path& file);
    /// The canonical path; "" if the file is missing.
    const std::filesystem::path& canonical_path(const std::filesystem::path& path);
    /// Number of files read so far.
    int reads() const { return m_reads; }

private:
    struct Known {
        Result<std::string> bytes;
        std::optional<Result<ShaderText>> found;  // parsed from the bytes
        std::optional<FileStamp> stamp;  // taken before reading; nullopt: too recent to be reliable
        std::filesystem::path canonical;  // the canonical path when read
        std::uint64_t reading = 0;        // the reading in which they were read
        std::uint64_t asked = 0;          // the last reading that used them
    };
    using Path = std::filesystem::path::string_type;

    std::optional<FileStamp> stamp_of(const std::filesystem::path& file) const;
    Known& known(const std::filesystem::path& file);

    ReadStamp m_read_stamp;
    std::uint64_t m_reading = 0;
    int m_reads = 0;
    std::unordered_map<Path, Known> m_known;
    std::unordered_map<Path, std::filesystem::path>
        m_canonical_paths;  // in this reading; "": missing
};
