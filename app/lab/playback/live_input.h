#pragma once

#include "lab/playback/audio_devices.h"
#include "model/devices/live_sound.h"

#include <cstdint>
#include <memory>
#include <string>

/// The live sound of an input device, on the player's clock.
class LiveInput {
public:
    /// Opens the device, unless it is open with enough channels. Its present sound gets this time.
    /// A muted input needs no device.
    Result<void> open(const AudioDevices& devices, int channels, double time);
    void close() { m_capture.reset(); }
    bool is_open() const { return m_capture != nullptr; }
    /// Closes the device if it is muted; call open() after it is unmuted.
    void set_muted(bool is_muted);
    bool is_muted() const { return m_is_muted; }
    /// "": not open.
    std::string device_name() const { return m_capture ? m_capture->device_name() : ""; }

    /// Maps the present sound to this time.
    void start_at(double time);
    /// Silence if the input is muted.
    std::shared_ptr<const LiveSound> sound() const;
    /// The frame of the sound at time 0.
    std::int64_t first_frame() const { return m_first_frame; }
    /// The time up to which an open input can be displayed.
    double end_seconds() const;
    /// Whether the open device has stopped.
    bool has_stalled() const { return m_capture && m_capture->has_stalled(); }

private:
    std::unique_ptr<SoundCapture> m_capture;
    bool m_is_muted = false;
    int m_channels = 0;  // requested from the device
    std::int64_t m_first_frame = 0;
};
