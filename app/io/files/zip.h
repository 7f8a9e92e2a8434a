#pragma once

#include "base/diagnostic.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

/// What an archive of unknown origin may contain.
struct ZipLimits {
    std::uint64_t files = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();  // unpacked
    double ratio = std::numeric_limits<double>::infinity();           // unpacked / packed
};

/// Writes all files of a folder to a ZIP file, with a fixed date, so that the same files give the
/// same bytes. Pictures, sounds and videos are stored without compression. `zip` is in a
/// scratch folder: the library leaves a file of its own when it is killed.
Result<void> zip_folder(const std::filesystem::path& folder, const std::filesystem::path& zip);

/// Fails for paths that are absolute, lead outside or differ in case only (ASCII), for links and
/// special files, and beyond the limits.
Result<void> check_zip(const std::filesystem::path& zip, const ZipLimits& limits);

/// The content of one file in an archive, at most `max_bytes`. "": the archive has no such file.
Result<std::string> read_in_zip(const std::filesystem::path& zip, const std::string& path,
                                std::size_t max_bytes);

/// Extracts a ZIP file to an existing folder. Fails as check_zip() before anything is written.
/// Stops if the content is larger than the archive states.
Result<void> unzip(const std::filesystem::path& zip, const std::filesystem::path& folder,
                   const ZipLimits& limits = {});
