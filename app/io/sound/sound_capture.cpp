#include "io/sound/sound_capture.h"

#include "io/sound/device_watch.h"
#include "io/sound/sound_api.h"
#include "io/sound/sound_clock.h"

#include <algorithm>

namespace {
using Clock = DeviceWatch::Clock;

/// An open stream of an input device: 32-bit float.
class Capture : public SoundCapture {
public:
    explicit Capture(RtAudio::Api api) : m_stream(api) { m_stream.showWarnings(false); }

    bool has_device() { return m_stream.getDeviceCount() > 0; }
    bool is_running() const { return m_stream.isStreamRunning(); }

    /// Throws RtAudioError.
    void start(const SoundSettings& settings, int channels) {
        const auto [device, info, rate] =
            choose_sound_device(m_stream, settings, SoundDirection::in);
        RtAudio::StreamParameters parameters;
        parameters.deviceId = device;
        parameters.nChannels =
            std::clamp(info.inputChannels, 1U, static_cast<unsigned int>(channels));
        RtAudio::StreamOptions options;
        options.streamName = "Afterglow";
        auto frames = static_cast<unsigned int>(settings.buffer);
        m_name = info.name;
        m_channels = static_cast<int>(parameters.nChannels);
        m_sound = std::make_shared<LiveSound>(static_cast<int>(rate), std::max(m_channels, 2));
        m_stream.openStream(nullptr, &parameters, RTAUDIO_FLOAT32, rate, &frames, take, this,
                            &options, ignore_while_running);
        // A trigger looks ahead a little, and two traces alternate every 1/60 s.
        constexpr double looked_ahead = 0.025;
        m_behind = looked_ahead + 2.0 * frames / rate;
        m_clock.buffer_filled({0.0, 1.0, 0}, Clock::now());
        m_watch.start(Clock::now());
        m_stream.startStream();
    }

    std::string device_name() const override { return m_name; }
    std::shared_ptr<const LiveSound> sound() const override { return m_sound; }
    double position_seconds() override { return m_clock.heard_seconds(Clock::now(), m_behind); }
    bool has_stalled() const override { return m_watch.is_lost(Clock::now()); }

private:
    static int take(void*, void* input, unsigned int frames, double, RtAudioStreamStatus,
                    void* self) {
        Capture& capture = *static_cast<Capture*>(self);
        if (!input)
            return 0;
        const std::size_t count =
            std::size_t{frames} * static_cast<std::size_t>(capture.m_channels);
        capture.m_sound->write({static_cast<const float*>(input), count}, capture.m_channels);
        const Clock::time_point now = Clock::now();
        capture.m_clock.buffer_filled({capture.m_sound->seconds(), 1.0, 0}, now);
        const double seconds = static_cast<double>(frames) / capture.m_sound->rate();
        return capture.m_watch.served(seconds, now) ? 0 : end_of_stream;
    }

    std::string m_name;
    int m_channels = 2;
    double m_behind = 0.0;               // s
    std::shared_ptr<LiveSound> m_sound;  // shared with the signals that draw it
    SoundClock m_clock;
    DeviceWatch m_watch;
    RtAudio m_stream;  // destroyed first, which ends the thread that uses the members above
};
}  // namespace

Result<std::unique_ptr<SoundCapture>> open_sound_capture(const SoundSettings& settings,
                                                         int channels) {
    auto opened = open_first_sound_device<Capture>(SoundDirection::in, settings, channels);
    if (!opened)
        return fail(opened.error());
    return std::move(*opened);
}
