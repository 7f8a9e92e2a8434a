#include "lab/library/shipped_files.h"

#include "base/file.h"
#include "base/text.h"

namespace fs = std::filesystem;

bool is_shipped(const ShippedFiles& shipped, const fs::path& root, const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
    const auto listed =
        shipped.find(whole.lexically_relative(root.lexically_normal()).generic_string());
    if (listed == shipped.end())
        return false;
    const auto bytes = read_bytes(file);
    return bytes && digest_of(*bytes) == listed->second;
}
