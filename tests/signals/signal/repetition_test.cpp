#include "model/tuning/repetition.h"

#include "signals/signal_making.h"
#include "signals/signal_table.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
std::unique_ptr<Signal> made(const char* text) {
    auto signal = make_signal(completed(parse_signal(text).value()).value(), {});
    REQUIRE(signal.has_value());
    return std::move(*signal);
}

std::optional<Fraction> period_of(const char* text) {
    const Repetition repetition = made(text)->repetition();
    CHECK(repetition.error == "");
    return common_period(repetition);
}

// The largest distance between the points of a frame and those of a frame `seconds` later.
double distance_after(const char* text, double seconds) {
    const auto signal = made(text);
    Beam now;
    Beam later;
    signal->trace({2.0, 2.0 + 1.0 / 60.0}, now);
    signal->trace({2.0 + seconds, 2.0 + seconds + 1.0 / 60.0}, later);
    REQUIRE(!now.empty());
    REQUIRE(now.size() == later.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < now.size(); ++i)
        largest = std::max(largest, std::hypot(static_cast<double>(now[i].x - later[i].x),
                                               static_cast<double>(now[i].y - later[i].y)));
    return largest;
}
}  // namespace

TEST_CASE("signals know after which time they draw the same points again") {
    struct Row {
        const char* text;
        Fraction seconds;
    };
    for (const Row& row :
         {Row{"lissajous:x=3,y=2", {1, 60}}, Row{"lissajous:x=3,y=2,speed=0.25", {4, 1}},
          Row{"harmonics:base=2,mode=xy", {1, 120}}, Row{"harmonics:base=2,speed=0.25", {2, 1}},
          Row{"am:carrier=24,modulator=2,speed=0.5", {1, 1}},
          Row{"fm:carrier=12,modulator=1,mode=xy", {1, 60}},
          Row{"waveform:mode=xy,ch1=sine,ch2=sine,f1=3,f2=2", {1, 60}},
          Row{"waveform:ch1=sine,ch2=off,f1=2,speed=0.5", {2, 1}},
          Row{"text:HI,size=0.1,spin=90", {4, 1}}, Row{"text:HI,size=0.1", {1, 60}}}) {
        CAPTURE(row.text);
        CHECK(period_of(row.text) == row.seconds);
        CHECK(distance_after(row.text, row.seconds.number()) < 1e-4);
    }
}

TEST_CASE("signals that never repeat say why") {
    CHECK(made("waveform:ch1=noise")->repetition().error.find("noise never repeats") == 0);
    const std::string slow = made("text:A LONG TEXT,beam_speed=20")->repetition().error;
    CHECK(slow.find("Raise the beam speed") != std::string::npos);
}
