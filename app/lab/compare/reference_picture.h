#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <filesystem>
#include <memory>

/// A picture from a file, as last read, for comparisons.
class ReferencePicture {
public:
    /// Reads the file. On failure the previous picture of the same file stays.
    Result<void> read(const std::filesystem::path& file);

    /// The last requested file, whether it exists or not; "": none.
    const std::filesystem::path& file() const { return m_file; }
    /// Null until a file was read. Each reading makes a new picture.
    const std::shared_ptr<const Picture>& picture() const { return m_picture; }

private:
    std::filesystem::path m_file;
    std::shared_ptr<const Picture> m_picture;  // shared with the code that uploads it
};
