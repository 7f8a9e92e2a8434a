#pragma once

#include "lab/messages/messages.h"
#include "lab/playback/player.h"
#include "lab/storage/roots.h"

#include <string>
#include <vector>

/// Audio devices: their settings, and notices about those that fail.
class AudioControl {
public:
    /// Applies the stored settings to the player.
    AudioControl(Player& player, const Roots& roots, Messages& messages);

    /// Opens the devices of the settings, and stores the settings.
    void set_settings(const SoundSettings& settings);
    /// The devices that find_devices() found.
    const std::vector<SoundDevice>& devices() const { return m_devices; }
    void find_devices() { m_devices = m_player.devices().list(); }
    /// Shows a notice once when a device fails or a live input is muted. A missing output is
    /// reported again only after an output has worked.
    void update();

private:
    Player& m_player;
    const Roots& m_roots;
    Messages& m_messages;
    std::vector<SoundDevice> m_devices;
    std::string m_reported;  // the last reported error
    std::string m_warned;    // the last reported one of an output, since an output worked
};
