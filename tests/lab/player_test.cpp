#include "lab/player.h"

#include <doctest/doctest.h>

namespace {
constexpr double sixtieth = 1.0 / 60.0;

PlayedSound second_of_sound() {
    return {"a.wav", std::make_shared<const Sound>(Sound{1000, 2, std::vector<float>(2000, 0.5f)})};
}
}  // namespace

TEST_CASE("frames join without a gap, and their number counts from 1") {
    Player player;
    double end = 0.0;
    for (int i = 1; i <= 100; ++i) {
        const auto frame = player.advance(i % 3 == 0 ? 0.031 : 0.007);
        REQUIRE(frame.has_value());
        CHECK(frame->number == i);
        CHECK(frame->span.start == end);
        end = frame->span.end;
    }
    CHECK(end == doctest::Approx(33 * 0.031 + 67 * 0.007));
}

TEST_CASE("speed scales time within 0.01 and 4") {
    Player player;
    player.set_speed(2.0);
    CHECK(player.advance(0.1)->span.end == doctest::Approx(0.2));
    player.set_speed(1000.0);
    CHECK(player.speed() == 4.0);
    player.set_speed(0.0);
    CHECK(player.speed() == 0.01);
}

TEST_CASE("paused there is no frame; a step is a sixtieth of a second") {
    Player player;
    player.advance(0.05);
    player.pause();
    CHECK_FALSE(player.advance(0.05).has_value());
    player.step();
    const auto frame = player.advance(0.05);
    REQUIRE(frame.has_value());
    CHECK(frame->span.seconds() == doctest::Approx(sixtieth));
    CHECK_FALSE(player.advance(0.05).has_value());
    player.play();
    CHECK(player.advance(0.05).has_value());
}

TEST_CASE("restart begins with frame 1 at time 0 and no past; seeking keeps the count") {
    Player player;
    player.advance(0.05);
    player.seek(7.0);
    const auto sought = player.advance(0.05);
    CHECK(sought->span.start == 7.0);
    CHECK(sought->number == 2);
    CHECK(player.past().size() == 2);
    player.restart();
    CHECK(player.past().empty());
    CHECK(player.advance(0.05)->number == 1);
}

TEST_CASE("a window that was held up loses time rather than drawing it in one frame") {
    Player player;
    CHECK(player.advance(100.0)->span.seconds() == doctest::Approx(0.25));
}

TEST_CASE("where a frame may cover only so much, time is shown more slowly, and it is told") {
    Player player;
    CHECK(player.shown_share() == 1.0);
    player.set_longest_frame(0.05);
    double end = 0.0;
    for (int i = 0; i < 60; ++i) {
        const auto frame = player.advance(0.6);  // what a frame takes on a slow machine
        CHECK(frame->span.start == end);         // nothing is left out
        CHECK(frame->span.seconds() == doctest::Approx(0.05));
        end = frame->span.end;
    }
    CHECK(player.shown_share() == doctest::Approx(0.05 / 0.6).epsilon(0.01));
    player.set_longest_frame(1.0);  // no more than a quarter of a second in any case
    CHECK(player.advance(0.6)->span.seconds() == doctest::Approx(0.25));
    for (int i = 0; i < 60; ++i)
        player.advance(sixtieth);
    CHECK(player.shown_share() == doctest::Approx(1.0).epsilon(0.01));
}

TEST_CASE("the fixed clock shows N/fps in frame N") {
    Player player;
    for (int n = 1; n <= 3; ++n) {
        const PlayedFrame frame = player.advance_fixed(24.0);
        CHECK(frame.number == n);
        CHECK(frame.span.start == doctest::Approx((n - 1) / 24.0));
        CHECK(frame.span.end == doctest::Approx(n / 24.0));
    }
}

TEST_CASE("a signal is set over its sound, and an unknown one leaves the last") {
    Player player;
    REQUIRE(player
                .set_signal(Spec{"audio", {{"file", std::string("a.wav")}, {"start", 0.25}}},
                            second_of_sound())
                .has_value());
    CHECK(player.sound_seconds() == doctest::Approx(0.75));
    const Signal* before = player.signal();
    CHECK_FALSE(player.set_signal(Spec{"no such kind", {}}).has_value());
    CHECK(player.signal() == before);
    CHECK(player.sound().sound != nullptr);
    REQUIRE(player.set_signal(Spec{"lissajous", {}}).has_value());
    CHECK(player.sound_seconds() == 0.0);
    CHECK_FALSE(player.trace({0.0, sixtieth}).empty());
    REQUIRE(player.set_signal({}).has_value());
    CHECK(player.trace({0.0, sixtieth}).empty());
}
