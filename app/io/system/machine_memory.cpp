#include "io/system/machine_memory.h"

#include <algorithm>
#include <fstream>
#include <unistd.h>

std::uint64_t machine_memory() {
    std::uint64_t bytes = static_cast<std::uint64_t>(std::max(::sysconf(_SC_PHYS_PAGES), 0L)) *
                          static_cast<std::uint64_t>(std::max(::sysconf(_SC_PAGESIZE), 0L));
    for (const char* file :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::uint64_t bound = 0;
        if (std::ifstream(file) >> bound && bound > 0)  // "max" is not a number
            bytes = std::min(bytes, bound);
    }
    return bytes;
}
