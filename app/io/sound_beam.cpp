#include "io/sound_beam.h"

#include "io/sound_api.h"

#include <atomic>
#include <chrono>
#include <optional>

namespace {
using Clock = std::chrono::steady_clock;

/// An open stream of an output device: 32-bit stereo.
class SoundBeam : public BeamOutput {
public:
    explicit SoundBeam(RtAudio::Api api) : m_stream(api) { m_stream.showWarnings(false); }

    bool has_device() { return m_stream.getDeviceCount() > 0; }
    bool is_running() const { return m_stream.isStreamRunning(); }

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
        options.streamName = "Afterglow beam";
        options.numberOfBuffers = 4;  // a sound server left to itself holds seconds
        auto frames = static_cast<unsigned int>(settings.buffer);
        m_name = info.name;
        m_queue.emplace(static_cast<int>(rate));
        m_asked = Clock::now();
        m_stream.openStream(&parameters, nullptr, RTAUDIO_FLOAT32, rate, &frames, fill, this,
                            &options, error_while_running);
        m_stream.startStream();
    }

    std::string device_name() const override { return m_name; }
    int rate() const override { return m_queue->rate(); }
    BeamQueue& queue() override { return *m_queue; }
    bool has_stalled() const override {
        return Clock::now() - m_asked.load() > std::chrono::seconds(1);
    }

private:
    static int fill(void* output, void*, unsigned int frames, double, RtAudioStreamStatus,
                    void* self) {
        SoundBeam& beam = *static_cast<SoundBeam*>(self);
        beam.m_queue->mix({static_cast<float*>(output), std::size_t{2} * frames});
        beam.m_asked = Clock::now();
        return 0;
    }

    // Without it RtAudio throws in the device's thread. What fails there shows as has_stalled().
    static void error_while_running(RtAudioError::Type, const std::string&) {}

    std::string m_name;
    std::optional<BeamQueue> m_queue;
    std::atomic<Clock::time_point> m_asked = Clock::time_point{};
    RtAudio m_stream;  // ends, and with it the thread, before what the thread uses
};
}  // namespace

Result<std::unique_ptr<BeamOutput>> open_sound_beam(const SoundSettings& settings) {
    std::unique_ptr<SoundBeam> opened;
    const auto done = open_first_sound_device("device", [&](RtAudio::Api api) {
        auto beam = std::make_unique<SoundBeam>(api);
        if (!beam->has_device())
            return false;
        beam->start(settings);
        if (!beam->is_running())
            return false;
        opened = std::move(beam);
        return true;
    });
    if (!done)
        return fail(
            {{}, 0, done.error().front().message + "; the beam is shown and goes nowhere else"});
    return opened;
}
