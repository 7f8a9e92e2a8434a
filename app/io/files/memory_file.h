#pragma once

#include <sndfile.h>

#include <cstddef>
#include <string>

/// A file in memory for libsndfile.
struct MemoryFile {
    std::string bytes;
    std::size_t position = 0;
};

/// libsndfile's callbacks for a MemoryFile, which is the user pointer of sf_open_virtual().
SF_VIRTUAL_IO memory_file_calls();
