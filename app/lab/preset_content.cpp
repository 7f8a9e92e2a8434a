#include "lab/preset_content.h"

#include "base/user_folders.h"
#include "model/source_spec.h"
#include "signals/kinds.h"
#include "signals/settings.h"

namespace fs = std::filesystem;

namespace {
// By its name alone: a link counts where it stands.
bool is_inside(const fs::path& file, const fs::path& folder) {
    const fs::path inside = fs::absolute(file).lexically_normal().lexically_relative(
        fs::absolute(folder).lexically_normal());
    return !inside.empty() && *inside.begin() != ".." && inside != ".";
}

bool is_recent(const fs::path& file, const RecentMedia& recent) {
    return recent.find(file.filename().string(), {}) == fs::absolute(file).lexically_normal();
}

// The socket that a signal makes; "" for none.
std::string socket_of(const Spec& signal) {
    const auto complete = completed(signal);
    return complete && complete->kind == "socket" ? std::string(Settings(*complete).word("path"))
                                                  : std::string();
}

// The file of the source or signal, as it would be opened; "" for none.
std::string file_named_by(const Preset& preset) {
    if (preset.source.empty())
        return preset.signal ? file_of(*preset.signal) : std::string();
    const auto source = parse_source(preset.source);
    return !source || source->is_pattern() ? std::string() : source->picture;
}
}  // namespace

std::string OutsideContent::words() const {
    const bool is_socket = signal && !socket_of(*signal).empty();
    return (is_socket ? "the socket '" : "the file '") + name + "'";
}

CheckedPreset with_checked_media(const Preset& preset, const fs::path& folder,
                                 const RecentMedia& recent) {
    CheckedPreset checked{with_found_media(preset, folder, recent)};
    const std::string socket = checked.preset.signal && checked.preset.source.empty()
                                   ? socket_of(*checked.preset.signal)
                                   : std::string();
    const std::string file = socket.empty() ? file_named_by(checked.preset) : std::string();
    const bool is_outside = !socket.empty() ? !is_inside(socket, runtime_folder())
                                            : !file.empty() && !is_inside(folder / file, folder) &&
                                                  !is_recent(file, recent);
    if (!is_outside)
        return checked;
    checked.outside = OutsideContent{socket.empty() ? file : socket, checked.preset.signal,
                                     checked.preset.source};
    checked.preset.signal.reset();
    checked.preset.source.clear();
    checked.preset.media_digest.clear();
    return checked;
}
