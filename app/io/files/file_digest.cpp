#include "io/files/file_digest.h"

#include "base/file.h"
#include "io/system/descriptor.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

Result<std::string> file_digest(const std::filesystem::path& file, JobProgress* work) {
    // Also checks that it is a regular file; opening a pipe would block forever.
    if (const auto start = read_start(file, 1); !start)
        return fail(start.error());
    const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    std::array<unsigned char, 1 << 16> block;
    uLong sum = crc32(0L, nullptr, 0);
    for (;;) {
        const ssize_t got = ::read(descriptor.get(), block.data(), block.size());
        if (got == 0)
            return fmt::format("{:08x}", sum);
        if (got < 0)
            return fail({file, 0, fmt::format("can't read the file: {}", std::strerror(errno))});
        if (work && work->is_cancelled)
            return fail({file, 0, "reading was cancelled"});
        sum = crc32(sum, block.data(), static_cast<uInt>(got));
    }
}
