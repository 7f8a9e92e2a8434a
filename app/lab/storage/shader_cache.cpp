#include "lab/storage/shader_cache.h"

#include "io/cache/disk_cache.h"
#include "io/system/process.h"
#include "lab/storage/file_stamp.h"
#include "lab/storage/roots.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
// Identifies this build, because another build can translate differently.
std::string this_program() {
    return fmt::format("afterglow {} {}", AFTERGLOW_VERSION, stamp_text({program_file()}));
}
}  // namespace

std::shared_ptr<ByteStore> shader_cache(const Roots& roots) {
    if (roots.cache.empty())
        return nullptr;
    return std::make_shared<DiskCache>(roots.cache / "shaders", this_program());
}
