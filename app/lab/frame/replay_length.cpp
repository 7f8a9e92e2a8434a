#include "lab/frame/replay_length.h"

#include <algorithm>

namespace {
// Whether frames depend on earlier ones, by targets or by the source.
bool has_memory(const Look& look) {
    const auto reads_past = [](const Pass& pass) {
        return pass.accumulate || std::ranges::any_of(pass.inputs, [](const Input& input) {
                   return input.frames_ago > 0;
               });
    };
    const std::vector<bool> feedback = feedback_passes(look);
    return std::ranges::find(feedback, true) != feedback.end() ||
           std::ranges::any_of(look.passes, reads_past);
}
}  // namespace

std::size_t settling_frames(const Workspace& work) {
    return static_cast<std::size_t>(std::max(work.document->look().settle_frames, 1));
}

ReplayLength replay_length(const Workspace& work) {
    constexpr double sample_budget_seconds = 0.2;
    constexpr std::size_t fewest = 4;
    const std::size_t all = settling_frames(work);
    if (work.redraw.replays_all())
        return {has_memory(work.document->look()) ? work.player.transport().past().size() : 1};
    if (!work.document->history().is_in_gesture())
        return {all};
    const auto affordable =
        static_cast<std::size_t>(sample_budget_seconds / work.renderer->times().frame_seconds());
    const std::size_t frames = std::clamp(affordable, std::min(fewest, all), all);
    return {frames, frames == all};
}
