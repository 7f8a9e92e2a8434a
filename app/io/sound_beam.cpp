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
        const OpenedOutput opened =
            open_stereo_output(m_stream, settings, "Afterglow beam", fill, this);
        m_name = opened.device;
        m_queue.emplace(static_cast<int>(opened.rate));
        m_asked = Clock::now();
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
