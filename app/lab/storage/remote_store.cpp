#include "lab/storage/remote_store.h"

#include "base/file.h"
#include "formats/settings/remote_settings_format.h"
#include "io/files/atomic_file.h"

namespace {
std::filesystem::path remote_file_in(const Roots& roots) {
    return roots.state / "remote.json";
}
}  // namespace

Result<RemoteSettings> load_remote_settings(const Roots& roots) {
    const std::filesystem::path file = remote_file_in(roots);
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return RemoteSettings{};
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    return parse_remote_settings(*text, file);
}

Result<void> save_remote_settings(const Roots& roots, const RemoteSettings& settings) {
    return write_atomically(remote_file_in(roots), remote_settings_to_json(settings));
}
