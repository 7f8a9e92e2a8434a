#include "io/files/memory_file.h"

#include <algorithm>
#include <cstring>

namespace {
MemoryFile& memory_of(void* user) {
    return *static_cast<MemoryFile*>(user);
}

sf_count_t length(void* user) {
    return static_cast<sf_count_t>(memory_of(user).bytes.size());
}

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    MemoryFile& file = memory_of(user);
    const sf_count_t from = whence == SEEK_SET   ? 0
                            : whence == SEEK_CUR ? static_cast<sf_count_t>(file.position)
                                                 : length(user);
    file.position = static_cast<std::size_t>(std::max<sf_count_t>(from + offset, 0));
    return static_cast<sf_count_t>(file.position);
}

sf_count_t read(void* to, sf_count_t count, void* user) {
    MemoryFile& file = memory_of(user);
    const std::size_t there = file.bytes.size() - std::min(file.position, file.bytes.size());
    const std::size_t got = std::min(static_cast<std::size_t>(count), there);
    std::memcpy(to, file.bytes.data() + std::min(file.position, file.bytes.size()), got);
    file.position += got;
    return static_cast<sf_count_t>(got);
}

sf_count_t write(const void* from, sf_count_t count, void* user) {
    MemoryFile& file = memory_of(user);
    const auto size = static_cast<std::size_t>(count);
    file.bytes.resize(std::max(file.bytes.size(), file.position + size));
    std::memcpy(file.bytes.data() + file.position, from, size);
    file.position += size;
    return count;
}

sf_count_t tell(void* user) {
    return static_cast<sf_count_t>(memory_of(user).position);
}
}  // namespace

SF_VIRTUAL_IO memory_file_calls() {
    return {length, seek, read, write, tell};
}
