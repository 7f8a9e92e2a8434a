#pragma once

#include "io/sound/level_ramp.h"
#include "model/devices/sound.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// Plays one sound into a device's buffers: a SoundOutput without the device. One thread controls
/// it and another calls mix(), which never waits, allocates or frees.
class SoundPlayer {
public:
    explicit SoundPlayer(int device_rate) : m_device_rate(device_rate) {}

    /// Plays the part from `start_seconds`, which is time 0 and the start of the loop, to
    /// `end_seconds`; 0: to the end. Null is silence. The sound has a rate and a channel.
    void play(std::shared_ptr<const Sound> sound, double start_seconds = 0.0,
              double end_seconds = 0.0);
    void set_paused(bool paused) { m_is_paused = paused; }
    /// Continues at this time of the sound; with a loop also beyond its end.
    void seek(double seconds);
    void set_loop(bool loops) { m_loops = loops; }
    /// 0 .. 2; reached over the length of a buffer, so that nothing clicks.
    void set_level(double level);
    /// 0.01 .. 4; changes the pitch too.
    void set_speed(double speed);

    /// The contents of a buffer.
    struct Mixed {
        double begin_seconds = 0.0;       // in the sound; counts on from loop to loop
        double seconds_per_second = 0.0;  // 0 if paused or at the end, otherwise the speed
        std::uint64_t jump = 0;           // the last seek before this buffer
    };
    /// Fills `stereo` with interleaved left and right samples within -1 .. 1. Interpolates linearly
    /// between samples of the sound's first two channels. Call it on the device's thread.
    Mixed mix(std::span<float> stereo) noexcept;

    /// The number of the last requested seek; a new sound counts as one.
    std::uint64_t jump() const { return m_jump; }

private:
    struct Track {
        std::shared_ptr<const Sound> sound;  // shared with the signal that draws it
        std::size_t first = 0;               // frame to start from
        std::size_t end = 0;                 // after the last frame

        std::size_t frame_count() const { return end - first; }
        const float* samples() const {
            return sound->samples.data() + first * static_cast<std::size_t>(sound->channels);
        }
    };

    struct Pace {
        double step = 1.0;  // samples of the sound per sample of the device
        bool loops = false;
    };

    const Track* begin_reading() noexcept;
    void follow_seek(const Sound& sound) noexcept;
    void add_sound(const Track& track, const Pace& pace, std::span<float> stereo) noexcept;
    void drop_unused_tracks();

    int m_device_rate;
    std::vector<std::unique_ptr<const Track>> m_tracks;  // kept while mix() may read them
    std::atomic<const Track*> m_track = nullptr;
    std::atomic<const Track*> m_in_use = nullptr;

    std::atomic<bool> m_is_paused = false;
    std::atomic<bool> m_loops = false;
    LevelRamp m_level{1.0, 1.0};
    std::atomic<double> m_speed = 1.0;
    std::atomic<double> m_seek_seconds = 0.0;
    std::atomic<std::uint64_t> m_jump = 0;

    // Used only by the device's thread.
    std::uint64_t m_jump_followed = 0;
    double m_position = 0.0;  // in samples of the sound
};
