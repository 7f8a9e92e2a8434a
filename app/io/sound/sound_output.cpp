#include "io/sound/sound_output.h"

#include "base/text.h"
#include "io/sound/device_watch.h"
#include "io/sound/sound_api.h"
#include "io/sound/sound_clock.h"
#include "io/sound/sound_player.h"

#include <algorithm>
#include <optional>

namespace {
using Clock = DeviceWatch::Clock;

/// An open stream of an output device: 32-bit float stereo.
class Output : public SoundOutput {
public:
    explicit Output(RtAudio::Api api) : m_stream(api) { m_stream.showWarnings(false); }

    bool has_device() { return m_stream.getDeviceCount() > 0; }
    bool is_running() const { return m_stream.isStreamRunning(); }

    /// Throws RtAudioError.
    void start(const SoundSettings& settings) {
        const OpenedOutput opened = open_stereo_output(m_stream, settings, "Afterglow", fill, this);
        m_player.emplace(static_cast<int>(opened.rate));
        m_name = opened.device;
        m_rate = opened.rate;
        m_buffered_seconds = opened.buffered_seconds;
        m_watch.start(Clock::now());
        m_stream.startStream();
    }

    std::string device_name() const override { return m_name; }

    void play(std::shared_ptr<const Sound> sound, double start_seconds,
              double end_seconds) override {
        m_player->play(std::move(sound), start_seconds, end_seconds);
        m_clock.seek_started(m_player->jump(), 0.0);
    }
    void play() override { m_player->set_paused(false); }
    void pause() override { m_player->set_paused(true); }
    void seek(double seconds) override {
        m_player->seek(seconds);
        m_clock.seek_started(m_player->jump(), std::max(seconds, 0.0));
    }
    void set_loop(bool loops) override { m_player->set_loop(loops); }
    void set_level(double level) override { m_player->set_level(level); }
    void set_speed(double speed) override { m_player->set_speed(speed); }

    double position_seconds() override {
        return m_clock.heard_seconds(Clock::now(), latency_seconds());
    }
    bool has_stalled() const override { return m_watch.is_lost(Clock::now()); }

private:
    static int fill(void* output, void*, unsigned int frames, double, RtAudioStreamStatus,
                    void* self) {
        Output& device = *static_cast<Output*>(self);
        const std::span stereo(static_cast<float*>(output), std::size_t{2} * frames);
        const SoundPlayer::Mixed mixed = device.m_player->mix(stereo);
        const Clock::time_point now = Clock::now();
        device.m_clock.buffer_filled(mixed, now);
        return device.m_watch.served(frames / device.m_rate, now) ? 0 : end_of_stream;
    }

    // From filling a buffer to hearing it: reported by the driver, otherwise the buffered time.
    double latency_seconds() {
        const long frames = m_stream.getStreamLatency();
        return frames > 0 ? static_cast<double>(frames) / m_rate : m_buffered_seconds;
    }

    std::string m_name;
    double m_rate = 48000.0;
    double m_buffered_seconds = 0.0;
    std::optional<SoundPlayer> m_player;
    SoundClock m_clock;
    DeviceWatch m_watch;
    RtAudio m_stream;  // destroyed first, which ends the thread that uses the members above
};
}  // namespace

Result<std::unique_ptr<SoundOutput>> open_sound_output(const SoundSettings& settings) {
    auto opened = open_first_sound_device<Output>(SoundDirection::out, settings);
    if (!opened)
        return fail({{}, 0, with_sentence(opened.error().front().message, "Playing silently.")});
    return std::move(*opened);
}
