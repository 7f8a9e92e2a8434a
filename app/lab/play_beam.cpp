#include "lab/play_beam.h"

#include "lab/signal_file.h"
#include "signals/kinds.h"

Result<Sound> play_beam(const std::string& text, const BeamSoundFormat& format) {
    const auto spec = parse_spec(text);
    if (!spec)
        return fail(spec.error());
    SignalMedia media;
    if (const std::string file = file_of(*spec); !file.empty()) {
        auto loaded = load_signal_media(file);
        if (!loaded)
            return fail(loaded.error());
        media = std::move(*loaded);
    }
    const auto signal = make_signal(*spec, media);
    if (!signal)
        return fail(signal.error());
    return beam_sound(**signal, format);
}
