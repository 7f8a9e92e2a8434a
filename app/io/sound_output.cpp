#include "io/sound_output.h"

#include "io/sound_api.h"
#include "io/sound_clock.h"
#include "io/sound_player.h"

#include <algorithm>
#include <optional>

namespace {
using Clock = std::chrono::steady_clock;
}  // namespace

/// An open stream of the device: 32-bit stereo.
class SoundOutput::Device {
public:
    explicit Device(RtAudio::Api api) : m_stream(api) { m_stream.showWarnings(false); }

    /// Throws RtAudioError.
    void start(const SoundSettings& settings) {
        const OpenedOutput opened = open_stereo_output(m_stream, settings, "Afterglow", fill, this);
        player.emplace(static_cast<int>(opened.rate));
        m_name = opened.device;
        m_rate = opened.rate;
        m_buffered_seconds = opened.buffered_seconds;
        m_stream.startStream();
    }

    bool has_device() { return m_stream.getDeviceCount() > 0; }
    bool is_running() const { return m_stream.isStreamRunning(); }
    const std::string& name() const { return m_name; }

    /// From filling a buffer to hearing it: what the driver says, else what it may hold.
    double latency_seconds() {
        const long frames = m_stream.getStreamLatency();
        return frames > 0 ? static_cast<double>(frames) / m_rate : m_buffered_seconds;
    }

    std::optional<SoundPlayer> player;
    SoundClock clock;

private:
    static int fill(void* output, void*, unsigned int frames, double, RtAudioStreamStatus,
                    void* self) {
        Device& device = *static_cast<Device*>(self);
        const std::span stereo(static_cast<float*>(output), std::size_t{2} * frames);
        const SoundPlayer::Mixed mixed = device.player->mix(stereo);
        device.clock.buffer_filled(mixed, Clock::now());
        return 0;
    }

    std::string m_name;
    double m_rate = 48000.0;
    double m_buffered_seconds = 0.0;
    RtAudio m_stream;  // ends, and with it the thread, before what the thread uses
};

Result<std::unique_ptr<SoundOutput>> SoundOutput::open(const SoundSettings& settings) {
    std::unique_ptr<SoundOutput> output;
    const auto done = open_first_sound_device("device", [&](RtAudio::Api api) {
        auto device = std::make_unique<Device>(api);
        if (!device->has_device())
            return false;
        device->start(settings);
        if (!device->is_running())
            return false;
        output.reset(new SoundOutput(std::move(device)));
        return true;
    });
    if (!done)
        return fail({{}, 0, done.error().front().message + "; the picture runs without sound"});
    return output;
}

SoundOutput::SoundOutput(std::unique_ptr<Device> device) : m_device(std::move(device)) {}

SoundOutput::~SoundOutput() = default;

std::string SoundOutput::device_name() const {
    return m_device->name();
}

void SoundOutput::play(std::shared_ptr<const Sound> sound, double start_seconds) {
    m_device->player->play(std::move(sound), start_seconds);
    m_device->clock.jumped(m_device->player->jump(), 0.0);
}

void SoundOutput::play() {
    m_device->player->set_paused(false);
}

void SoundOutput::pause() {
    m_device->player->set_paused(true);
}

void SoundOutput::seek(double seconds) {
    m_device->player->seek(seconds);
    m_device->clock.jumped(m_device->player->jump(), std::max(seconds, 0.0));
}

void SoundOutput::set_loop(bool loops) {
    m_device->player->set_loop(loops);
}

void SoundOutput::set_level(double level) {
    m_device->player->set_level(level);
}

void SoundOutput::set_speed(double speed) {
    m_device->player->set_speed(speed);
}

double SoundOutput::position_seconds() const {
    return m_device->clock.heard_seconds(Clock::now(), m_device->latency_seconds());
}

bool SoundOutput::has_stalled() const {
    return m_device->clock.seconds_since_buffer(Clock::now()) > 1.0;
}
