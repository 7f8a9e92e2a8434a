#include "lab/storage/remote_store.h"

#include "base/file.h"
#include "formats/settings/remote_settings_format.h"
#include "io/files/atomic_file.h"
#include "lab/storage/instance_lock.h"

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
    auto settings = parse_remote_settings(*text, file);
    if (settings && roots.instance > 1)
        settings->listens_to_osc = false;
    return settings;
}

Result<void> save_remote_settings(const Roots& roots, const RemoteSettings& settings) {
    RemoteSettings saved = settings;
    if (roots.instance > 1) {
        const auto of_first = load_remote_settings(first_instance(roots));
        saved.listens_to_osc = of_first && of_first->listens_to_osc;
    }
    return write_atomically(remote_file_in(roots), remote_settings_to_json(saved));
}
