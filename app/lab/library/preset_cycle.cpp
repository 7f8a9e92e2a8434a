#include "lab/library/preset_cycle.h"

#include <algorithm>

namespace {
int wrapped(int index, int count) {
    return (index % count + count) % count;
}

// The index from 1; 0: not in the list.
int index_among(const std::vector<PresetEntry>& presets, const std::filesystem::path& open) {
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const PresetEntry& preset) {
        std::error_code ignored;
        return !open.empty() &&
               (preset.file == open || std::filesystem::equivalent(preset.file, open, ignored));
    });
    return found == presets.end() ? 0 : static_cast<int>(found - presets.begin()) + 1;
}
}  // namespace

PresetIndex preset_after(const std::vector<PresetEntry>& presets, const std::filesystem::path& open,
                         int by) {
    const int count = static_cast<int>(presets.size()) + 1;
    const auto next = static_cast<std::size_t>(wrapped(index_among(presets, open) + by, count));
    return {next == 0 ? std::filesystem::path() : presets[next - 1].file, next, presets.size()};
}

std::optional<PresetIndex> favourite_after(const std::vector<PresetEntry>& presets,
                                           const FavouritePresets& stars,
                                           const std::filesystem::path& open, int by) {
    const int current = index_among(presets, open);
    std::vector<std::filesystem::path> starred;
    int before = 0;  // number of starred ones up to the open one
    bool is_current_favourite = false;
    for (int i = 0; i < static_cast<int>(presets.size()); ++i) {
        const PresetEntry& preset = presets[static_cast<std::size_t>(i)];
        if (!stars.contains(favourite_key(preset.look, preset.id)))
            continue;
        starred.push_back(preset.file);
        before += i + 1 <= current ? 1 : 0;
        is_current_favourite = is_current_favourite || i + 1 == current;
    }
    if (starred.empty())
        return std::nullopt;
    // If the open preset is not starred, one step back is the previous starred one.
    const int shift = !is_current_favourite && by < 0 ? 1 : 0;
    const auto next = static_cast<std::size_t>(
        wrapped(before - 1 + by + shift, static_cast<int>(starred.size())));
    return PresetIndex{starred[next], next + 1, starred.size()};
}
