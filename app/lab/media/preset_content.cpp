#include "lab/media/preset_content.h"

#include "base/user_folders.h"
#include "model/picture/source_spec.h"
#include "signals/signal/settings.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <utility>

namespace fs = std::filesystem;

namespace {
// Compares paths only. Symbolic links are not resolved.
bool is_inside(const fs::path& file, const fs::path& folder) {
    const fs::path inside = fs::absolute(file).lexically_normal().lexically_relative(
        fs::absolute(folder).lexically_normal());
    return !inside.empty() && *inside.begin() != ".." && inside != ".";
}

bool is_asked_for(const fs::path& file, const fs::path& folder, const RecentMedia& recent) {
    return !is_inside(file, folder) && !recent.has(file);
}

// The socket path of a signal; "": not a socket.
std::string socket_of(const Spec& signal) {
    const auto complete = completed(signal);
    return complete && complete->kind == "socket" ? std::string(Settings(*complete).word("path"))
                                                  : std::string();
}

// The file of the source or signal, as it would be opened; "": no file.
std::string file_named_by(const Preset& preset) {
    if (preset.source.empty())
        return preset.signal ? file_of(*preset.signal) : std::string();
    const auto source = parse_source(preset.source);
    return source && source->is_file() ? source->picture : std::string();
}

// The source that records a window, the screen, a camera or a pipe; "": none.
std::string live_source_of(const Preset& preset) {
    const auto source = parse_source(preset.source);
    return source && source->is_live() ? source->picture : std::string();
}

// Moves the signal or source to `outside` if it needs the user's consent.
void separate_drive(Preset& preset, const fs::path& folder, const RecentMedia& recent,
                    OutsideContent& outside) {
    const std::string socket =
        preset.signal && preset.source.empty() ? socket_of(*preset.signal) : std::string();
    const std::string live = live_source_of(preset);
    const std::string file = socket.empty() ? file_named_by(preset) : std::string();
    const bool is_outside = !socket.empty() ? !is_inside(socket, runtime_folder())
                            : !live.empty()
                                ? !recent.has(live)
                                : !file.empty() && is_asked_for(folder / file, folder, recent);
    if (!is_outside)
        return;
    outside.name = !socket.empty() ? socket : live.empty() ? file : live;
    outside.signal = std::exchange(preset.signal, std::nullopt);
    outside.source = std::exchange(preset.source, {});
    preset.media_digest.clear();
}

void separate_files(Preset& preset, const Look& look, const fs::path& folder,
                    const RecentMedia& recent, OutsideContent& outside) {
    preset.values = renamed_values(look, std::move(preset.values));
    std::erase_if(preset.values, [&](const auto& entry) {
        const auto& [name, value] = entry;
        const bool is_outside =
            names_file(look, name, value) && is_asked_for(value.path, folder, recent);
        if (is_outside)
            outside.files.emplace(name, value);
        return is_outside;
    });
}
}  // namespace

std::string OutsideContent::names(char quote) const {
    constexpr std::size_t max_named = 3;
    const bool is_socket = signal && !socket_of(*signal).empty();
    std::vector<std::string> named;
    if (!name.empty())
        named.push_back(is_live(name) ? fmt::format("live source {0}{1}{0}", quote, name)
                        : is_socket   ? fmt::format("socket {0}{1}{0}", quote, name)
                                      : fmt::format("file {0}{1}{0}", quote, name));
    for (auto file = files.begin(); file != files.end() && named.size() < max_named; ++file)
        named.push_back(fmt::format("file {0}{1}{0}", quote, file->second.path));
    if (count() > named.size())
        named.push_back(fmt::format("{} more", count() - named.size()));
    return fmt::format("{}", fmt::join(named, ", "));
}

std::string OutsideContent::notice() const {
    return fmt::format("The preset uses content outside its folder: {}. It was not loaded.",
                       names('"'));
}

std::string OutsideContent::refusal() const {
    std::vector<std::string> options;
    if (!name.empty())
        options.emplace_back("--signal or --source");
    if (!files.empty())
        options.push_back(fmt::format("--set {}=FILE", files.begin()->first));
    return fmt::format(
        "the preset uses content outside its folder: {}. If you trust it, load it with {}.",
        names('\''), fmt::join(options, " and "));
}

CheckedPreset with_checked_media(const Preset& preset, const Look& look, const fs::path& folder,
                                 const RecentMedia& recent) {
    CheckedPreset checked{with_found_files(with_found_media(preset, folder, recent), look, folder)};
    OutsideContent outside;
    separate_drive(checked.preset, folder, recent, outside);
    separate_files(checked.preset, look, folder, recent, outside);
    if (outside.count() > 0)
        checked.outside = std::move(outside);
    return checked;
}
