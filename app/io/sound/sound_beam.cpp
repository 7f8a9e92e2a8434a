#include "io/sound/sound_beam.h"

#include "base/text.h"
#include "io/sound/device_watch.h"
#include "io/sound/sound_api.h"

#include <optional>

namespace {
using Clock = DeviceWatch::Clock;

/// An open stream of an output device: 32-bit float stereo.
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
        m_watch.start(Clock::now());
        m_stream.startStream();
    }

    std::string device_name() const override { return m_name; }
    int rate() const override { return m_queue->rate(); }
    BeamQueue& queue() override { return *m_queue; }
    bool has_stalled() const override { return m_watch.is_lost(Clock::now()); }

private:
    static int fill(void* output, void*, unsigned int frames, double, RtAudioStreamStatus,
                    void* self) {
        SoundBeam& beam = *static_cast<SoundBeam*>(self);
        beam.m_queue->mix({static_cast<float*>(output), std::size_t{2} * frames});
        const double seconds = static_cast<double>(frames) / beam.rate();
        return beam.m_watch.served(seconds, Clock::now()) ? 0 : end_of_stream;
    }

    std::string m_name;
    std::optional<BeamQueue> m_queue;
    DeviceWatch m_watch;
    RtAudio m_stream;  // destroyed first, which ends the thread that uses the members above
};
}  // namespace

Result<std::unique_ptr<BeamOutput>> open_sound_beam(const SoundSettings& settings) {
    auto opened = open_first_sound_device<SoundBeam>(SoundDirection::out, settings);
    if (!opened)
        return fail({{},
                     0,
                     with_sentence(opened.error().front().message,
                                   "The beam is only shown on the screen.")});
    return std::move(*opened);
}
