#include "io/sound_output.h"

#include "io/sound_clock.h"
#include "io/sound_player.h"

#include <RtAudio.h>

#include <algorithm>
#include <array>
#include <dlfcn.h>
#include <optional>

namespace {
using Clock = std::chrono::steady_clock;

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

// ALSA tells of each device that it does not find on stderr. It is in the process only where
// RtAudio was built with it, so its function is looked for by name.
void silence_alsa() {
    using SetHandler = int (*)(decltype(&say_nothing));
    if (void* const found = dlsym(RTLD_DEFAULT, "snd_lib_error_set_handler"))
        reinterpret_cast<SetHandler>(found)(say_nothing);
}

// What is there to try, sound servers first: they share the device with other programs.
std::vector<RtAudio::Api> usable_apis() {
    constexpr std::array wanted{RtAudio::LINUX_PULSE, RtAudio::LINUX_ALSA,  RtAudio::UNIX_JACK,
                                RtAudio::LINUX_OSS,   RtAudio::MACOSX_CORE, RtAudio::WINDOWS_WASAPI,
                                RtAudio::WINDOWS_DS};
    std::vector<RtAudio::Api> compiled;
    RtAudio::getCompiledApi(compiled);
    std::vector<RtAudio::Api> usable;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(usable), [&](RtAudio::Api api) {
        return std::find(compiled.begin(), compiled.end(), api) != compiled.end();
    });
    return usable;
}
}  // namespace

/// An open stream of the device: 32-bit stereo.
class SoundOutput::Device {
public:
    explicit Device(RtAudio::Api api) : m_stream(api) { m_stream.showWarnings(false); }

    /// Throws RtAudioError.
    void start() {
        const unsigned int device = m_stream.getDefaultOutputDevice();
        const RtAudio::DeviceInfo info = m_stream.getDeviceInfo(device);
        const unsigned int rate = info.preferredSampleRate > 0 ? info.preferredSampleRate : 48000;
        RtAudio::StreamParameters parameters;
        parameters.deviceId = device;
        parameters.nChannels = 2;
        RtAudio::StreamOptions options;
        options.streamName = "Afterglow";
        options.numberOfBuffers = 4;  // a sound server left to itself holds seconds
        unsigned int frames = 512;
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

Result<std::unique_ptr<SoundOutput>> SoundOutput::open() {
    silence_alsa();
    std::string reason = "no sound device was found";
    for (const RtAudio::Api api : usable_apis()) {
        try {
            auto device = std::make_unique<Device>(api);
            if (!device->has_device())
                continue;
            device->start();
            if (device->is_running())
                return std::unique_ptr<SoundOutput>(new SoundOutput(std::move(device)));
            reason = "the sound device does not start";
        } catch (const RtAudioError& error) {
            reason = "the sound device cannot be opened: " + error.getMessage();
        }
    }
    return fail({{}, 0, reason + "; the picture runs without sound"});
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
