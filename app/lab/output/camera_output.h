#pragma once

#include "lab/output/camera_feed.h"

#include <chrono>

class Messages;
class Renderer;
struct OutputState;

/// The virtual camera of the window. It shows the picture of the look in its render size.
class CameraOutput {
public:
    /// `wake` is called on another thread when update() has work.
    explicit CameraOutput(std::function<void()> wake) : m_wake(std::move(wake)) {}

    /// Opens or closes the camera as `state` requires, and shows the new picture. If the camera
    /// can't be opened or has ended, switches it off in `state` and reports why. `pass`: the pass
    /// that is displayed as the picture. `renderer`: null without a look.
    void update(OutputState& state, const Renderer* renderer, int pass, Messages& messages);

private:
    /// The picture that was shown last.
    struct Shown {
        std::uint64_t number = 0;  // of the content of the textures
        int pass = 0;

        bool operator==(const Shown&) const = default;
    };

    bool open(Extent extent, Messages& messages);
    void show(const Renderer& renderer, const Shown& wanted);
    void keep_black();
    bool is_changing(Extent extent);

    std::function<void()> m_wake;
    std::unique_ptr<CameraFeed> m_feed;  // null: off
    Extent m_extent;                     // of the camera
    Extent m_wanted_extent;              // of the picture
    std::chrono::steady_clock::time_point m_wanted_since;
    std::optional<Shown> m_shown;  // nullopt: black
};
