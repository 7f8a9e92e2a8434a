#pragma once

#include <sndfile.h>

#include <cstddef>
#include <string>

/// A file in memory, as libsndfile reads or writes one.
struct MemoryFile {
    std::string bytes;
    std::size_t place = 0;
};

/// How libsndfile works on a MemoryFile, which is the user's pointer of sf_open_virtual().
SF_VIRTUAL_IO memory_file_calls();
