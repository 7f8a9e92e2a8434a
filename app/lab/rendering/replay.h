#pragma once

#include "lab/playback/player.h"

#include <cstddef>
#include <functional>

class Renderer;

/// Draws the latest frames of a player again, from an empty history: for a paused picture, or for a
/// new variant.
class Replay {
public:
    explicit Replay(Renderer& renderer) : m_renderer(renderer) {}

    /// Starts with the latest `frames` frames.
    void start(const Player& player, std::size_t frames);
    /// The same for the variant only. The picture stays unchanged.
    void start_variant(const Player& player, std::size_t frames);
    /// Called before each frame, to set its source and values.
    using BeforeFrame = std::function<void(const PlayedFrame&)>;
    /// Draws for about `seconds`; true when the replay has just ended.
    bool update(const Player& player, double seconds, const BeforeFrame& before);
    void cancel();

    bool is_running() const { return m_done < m_total; }
    bool is_of_variant() const { return is_running() && m_is_of_variant; }
    std::size_t done() const { return m_done; }    // frames
    std::size_t total() const { return m_total; }  // frames

private:
    void begin(const Player& player, std::size_t frames);

    Renderer& m_renderer;
    std::size_t m_first = 0;  // in the past of the player
    std::size_t m_done = 0;
    std::size_t m_total = 0;
    bool m_is_of_variant = false;
};
