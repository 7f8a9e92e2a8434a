#include "lab/playback/audio_control.h"

#include "io/temporary_folder.h"
#include "lab/no_sound_devices.h"
#include "signals/signal_table.h"

#include <doctest/doctest.h>

namespace {
SignalFile short_sound() {
    return {"a.wav", std::make_shared<const Sound>(Sound{1000, 2, std::vector<float>(2000, 0.5f)})};
}

Spec spec_of(const char* text) {
    return completed(parse_signal(text).value()).value();
}
}  // namespace

TEST_CASE("a missing output device is reported once, as a warning, however often a sound starts") {
    const TemporaryFolder folder;
    const Roots roots{folder.path(), folder / "user", folder / "state"};
    Messages messages;
    Player player(std::make_unique<NoSoundDevices>());
    AudioControl audio(player, roots, messages);
    REQUIRE(player.set_signal(spec_of("audio:a.wav"), short_sound()).has_value());
    audio.update();
    REQUIRE(messages.notice());
    CHECK(messages.notice()->text == "No audio device found");
    CHECK(messages.notice()->is_warning);
    CHECK_FALSE(messages.notice()->is_problem);
    for (const char* next : {"lissajous", "audio:b.wav", "lissajous", "audio:c.wav"}) {
        const Spec spec = spec_of(next);
        const SignalFile file = spec.kind == "audio" ? short_sound() : SignalFile{};
        REQUIRE(player.set_signal(spec, file).has_value());
        audio.update();
        CHECK_FALSE(messages.notice());  // the first one is withdrawn, and no other follows
    }
}
