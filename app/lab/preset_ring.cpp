#include "lab/preset_ring.h"

#include <algorithm>

PresetPlace preset_beside(const std::vector<PresetEntry>& presets,
                          const std::filesystem::path& open, int by) {
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const PresetEntry& preset) {
        std::error_code ignored;
        return !open.empty() &&
               (preset.file == open || std::filesystem::equivalent(preset.file, open, ignored));
    });
    const int count = static_cast<int>(presets.size()) + 1;
    const int place = found == presets.end() ? 0 : static_cast<int>(found - presets.begin()) + 1;
    const auto next = static_cast<std::size_t>(((place + by) % count + count) % count);
    return {next == 0 ? std::filesystem::path() : presets[next - 1].file, next};
}
