#include "io/system/locked_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace {
bool lock(const Descriptor& file) {
    return file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}
}  // namespace

LockedFile::LockedFile(const std::filesystem::path& file)
    : m_descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}

bool LockedFile::replace(std::string_view text) const {
    return lock(m_descriptor) && ::ftruncate(m_descriptor.get(), 0) == 0 &&
           ::pwrite(m_descriptor.get(), text.data(), text.size(), 0) ==
               static_cast<ssize_t>(text.size());
}

bool is_unlocked(const std::filesystem::path& file) {
    return lock(Descriptor(::open(file.c_str(), O_RDWR | O_CLOEXEC)));
}
