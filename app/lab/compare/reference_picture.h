#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <filesystem>
#include <memory>

/// A picture from a file that others are compared with, as it was last read.
class ReferencePicture {
public:
    /// Reads the file. Where it is broken, what was read of the same file before stays.
    Result<void> read(const std::filesystem::path& file);

    /// That was asked for last, there or not; "": none.
    const std::filesystem::path& file() const { return m_file; }
    /// Null where nothing could be read yet; another one each time that it was read.
    const std::shared_ptr<const Picture>& picture() const { return m_picture; }

private:
    std::filesystem::path m_file;
    std::shared_ptr<const Picture> m_picture;  // shared with who has it on the GPU
};
