#pragma once

#include "io/control/midi_inputs.h"

#include <deque>
#include <string>
#include <vector>

/// Connected device names and their pending messages.
struct FakeDevice {
    std::vector<std::string> plugged = {"nanoKONTROL"};
    std::deque<std::vector<std::uint8_t>> messages;
};

/// MIDI inputs that receive the messages of a FakeDevice.
class FakeMidi : public MidiInputs {
public:
    explicit FakeMidi(FakeDevice& device) : m_device(device) {}
    Result<void> open() override {
        m_names = m_device.plugged;
        return m_names.empty() ? fail({{}, 0, "no device found"}) : Result<void>();
    }
    void close() override { m_names.clear(); }
    std::vector<std::string> names() const override { return m_names; }
    std::optional<std::vector<std::uint8_t>> take() override {
        if (m_names.empty() || m_device.messages.empty())
            return std::nullopt;
        auto message = m_device.messages.front();
        m_device.messages.pop_front();
        return message;
    }
    int descriptor() const override { return -1; }

private:
    FakeDevice& m_device;
    std::vector<std::string> m_names;
};
