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
        const unsigned int device =
            find_sound_device(m_stream, settings.output, SoundDirection::out);
        const RtAudio::DeviceInfo info = m_stream.getDeviceInfo(device);
        const unsigned int own = info.preferredSampleRate > 0 ? info.preferredSampleRate : 48000;
        const unsigned int rate = settings.rate > 0 ? static_cast<unsigned>(settings.rate) : own;
        RtAudio::StreamParameters parameters;
        parameters.deviceId = device;
        parameters.nChannels = 2;
        RtAudio::StreamOptions options;
        options.streamName = "Afterglow";
        options.numberOfBuffers = 4;  // a sound server left to itself holds seconds
        auto frames = static_cast<unsigned int>(settings.buffer);
        player.emplace(static_cast<int>(rate));
        m_stream.openStream(&parameters, nullptr, RTAUDIO_FLOAT32, rate, &frames, fill, this,
                            &options, error_while_running);
        m_name = info.name;
        m_rate = rate;
        m_buffered_seconds = static_cast<double>(frames) * options.numberOfBuffers / rate;
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

    // Without it RtAudio throws in the device's thread. What fails there shows as has_stalled().
    static void error_while_running(RtAudioError::Type, const std::string&) {}

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
