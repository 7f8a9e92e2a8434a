#include "lab/storage/kept_shaders.h"

#include "io/cache/kept_files.h"
#include "lab/storage/file_stamp.h"
#include "lab/storage/roots.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
// Identifies this build, because another build can translate differently.
std::string this_program() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return fmt::format("afterglow {} {}", AFTERGLOW_VERSION, stamp_of({program}));
}
}  // namespace

std::shared_ptr<ByteStore> kept_shaders(const Roots& roots) {
    if (roots.cache.empty())
        return nullptr;
    return std::make_shared<KeptFiles>(roots.cache / "shaders", this_program());
}
