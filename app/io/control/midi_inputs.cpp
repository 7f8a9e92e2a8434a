#include "io/control/midi_inputs.h"

#include "io/system/descriptor.h"

#include <fmt/format.h>

#include <RtMidi.h>
#include <deque>
#include <mutex>
#include <sys/eventfd.h>
#include <unistd.h>

namespace {
constexpr const char* our_name = "Afterglow";

// Errors are detected by their effects, not by RtMidi's messages.
void ignore_midi_error(RtMidiError::Type, const std::string&, void*) {}

/// Messages from the device threads, with an eventfd that wakes a sleeping reader.
class MidiQueue {
public:
    MidiQueue() : m_bell(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

    void put(const std::vector<unsigned char>& message) {
        constexpr std::size_t maximum = 4096;  // drops messages that are not read
        {
            const std::lock_guard lock(m_mutex);
            if (m_messages.size() >= maximum)
                return;
            m_messages.emplace_back(message.begin(), message.end());
        }
        static_cast<void>(::eventfd_write(m_bell.get(), 1));
    }
    std::optional<std::vector<std::uint8_t>> take() {
        const std::lock_guard lock(m_mutex);
        if (m_messages.empty()) {
            eventfd_t rung = 0;
            static_cast<void>(::eventfd_read(m_bell.get(), &rung));
            return std::nullopt;
        }
        auto message = std::move(m_messages.front());
        m_messages.pop_front();
        return message;
    }
    void clear() {
        const std::lock_guard lock(m_mutex);
        m_messages.clear();
    }
    int descriptor() const { return m_bell.get(); }

private:
    std::mutex m_mutex;
    std::deque<std::vector<std::uint8_t>> m_messages;
    Descriptor m_bell;
};

class MachineMidi : public MidiInputs {
public:
    Result<void> open() override;
    void close() override {
        m_inputs.clear();
        m_ports.clear();
        m_names.clear();
        m_queue.clear();
    }
    std::vector<std::string> names() const override { return m_names; }
    std::optional<std::vector<std::uint8_t>> take() override { return m_queue.take(); }
    const MidiClockInput* clock() const override { return &m_clock; }
    int descriptor() const override { return m_queue.descriptor(); }

private:
    void open_all();
    /// An open device, for its callback.
    struct Port {
        MachineMidi& owner;
        std::size_t number = 0;
    };
    static void come(double, std::vector<unsigned char>* message, void* data) {
        constexpr unsigned char quarter_frame = 0xF1;  // MIDI time code, 100 times per second
        if (!message->empty() && message->front() == quarter_frame)
            return;
        const Port& port = *static_cast<Port*>(data);
        if (MidiClockInput::is_clock_message(*message))
            port.owner.m_clock.receive(*message, port.number, MidiClockInput::now());
        else
            port.owner.m_queue.put(*message);
    }

    MidiQueue m_queue;  // outlives the inputs that write to it, as the clock and the ports do
    MidiClockInput m_clock;
    std::vector<std::unique_ptr<Port>> m_ports;
    std::vector<std::unique_ptr<RtMidiIn>> m_inputs;
    std::vector<std::string> m_names;
};

std::unique_ptr<RtMidiIn> make_input() {
    auto input = std::make_unique<RtMidiIn>(RtMidi::LINUX_ALSA, our_name);
    input->setErrorCallback(ignore_midi_error);
    return input;
}

// ALSA's loopback port between programs and our own ports are not devices.
bool is_device(const std::string& name) {
    return !name.starts_with("Midi Through") && !name.starts_with(our_name);
}

void MachineMidi::open_all() {
    const auto scout = make_input();
    for (unsigned int port = 0; port < scout->getPortCount(); ++port) {
        const std::string name = scout->getPortName(port);
        if (!is_device(name))
            continue;
        auto input = make_input();
        input->ignoreTypes(true, false, true);
        m_ports.push_back(std::make_unique<Port>(Port{*this, m_ports.size()}));
        input->setCallback(come, m_ports.back().get());
        input->openPort(port, our_name);
        if (!input->isPortOpen())
            continue;
        m_inputs.push_back(std::move(input));
        m_names.push_back(name);
    }
}

Result<void> MachineMidi::open() {
    close();
    // Checked first: the library would print an error to stderr.
    constexpr const char* sequencer = "/dev/snd/seq";
    if (::access(sequencer, R_OK | W_OK) != 0)
        return fail(
            {{},
             0,
             fmt::format("no device found: this computer has no ALSA sequencer ({})", sequencer)});
    try {
        open_all();
    } catch (const RtMidiError& error) {
        close();
        return fail({{}, 0, fmt::format("can't open the devices: {}", error.getMessage())});
    }
    if (m_names.empty())
        return fail({{}, 0, "no device found. Connect one and rescan."});
    return {};
}
}  // namespace

std::unique_ptr<MidiInputs> machine_midi_inputs() {
    return std::make_unique<MachineMidi>();
}
