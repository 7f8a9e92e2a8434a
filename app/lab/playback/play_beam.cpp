#include "lab/playback/play_beam.h"

#include "lab/playback/beam_feed.h"
#include "lab/playback/signal_file.h"
#include "signals/signal_table.h"

Result<Sound> play_beam(const std::string& text, const BeamSoundFormat& format,
                        Diagnostics& problems) {
    const auto spec = parse_signal(text);
    if (!spec)
        return fail(spec.error());
    SignalMedia media;
    if (const std::string file = file_of(*spec); !file.empty()) {
        auto loaded = load_signal_media(file, nullptr, &problems);
        if (!loaded)
            return fail(loaded.error());
        media = std::move(*loaded);
    }
    std::unique_ptr<BeamFeed> feed;
    if (const auto complete = completed(*spec); complete && find_kind(complete->kind)->is_sent) {
        auto opened = BeamFeed::open(*complete, BeamInput::Pace::waiting, 0.0);
        if (!opened)
            return fail(opened.error());
        feed = std::move(*opened);
        media.sent = feed->beam();
    }
    const auto signal = make_signal(*spec, media);
    if (!signal)
        return fail(signal.error());
    Sound sound = beam_sound(**signal, format);
    if (feed)
        add_new(problems, feed->problems());
    return sound;
}
