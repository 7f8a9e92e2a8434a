#include "signals/beam/beam_sound.h"

#include "signals/signal_making.h"

TEST_CASE("the sound of a beam has its position at each sample's time") {
    // x has 3 and y 2 periods of a sine in 1/60 s, a quarter turn apart.
    const auto signal = signal_of("lissajous:x=3,y=2,phase=0.25,amplitude=0.8");
    const Sound sound = beam_sound(*signal, {.seconds = 0.1, .rate = 48000, .channels = 3});
    REQUIRE(sound.channels == 3);
    REQUIRE(sound.frame_count() == 4800);
    for (std::size_t i = 10; i < 4800; i += 7) {
        const double u = (static_cast<double>(i) + 1.0) / 48000.0 * 60.0;
        CAPTURE(i);
        CHECK(std::abs(sound.samples[3 * i] - 0.8 * sine_at(3.0, u + 0.25 / 3.0)) < 1e-3);
        CHECK(std::abs(sound.samples[3 * i + 1] - 0.8 * sine_at(2.0, u)) < 1e-3);
        CHECK(std::abs(sound.samples[3 * i + 2] - 1.0) < 1e-2);  // full current
    }
}

TEST_CASE("a third channel has the current, which is 0 during blanked moves") {
    const auto signal = signal_of("text:I I,beam_speed=400");
    const Sound sound = beam_sound(*signal, {.seconds = 0.05, .rate = 48000, .channels = 3});
    std::size_t dark = 0;
    for (std::size_t i = 2; i < sound.samples.size(); i += 3)
        dark += sound.samples[i] == 0.0f ? 1 : 0;
    CHECK(dark > 100);
    CHECK(dark < sound.frame_count());
    CHECK(beam_sound(*signal, {.seconds = 0.05}).samples.size() == 2 * 2400);
}
