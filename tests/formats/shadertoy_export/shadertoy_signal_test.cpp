#include "formats/shadertoy_export/shadertoy_signal.h"

#include "signals/signal_table.h"

#include <doctest/doctest.h>

namespace {
Result<ShadertoySignal> written(const char* spec) {
    return shadertoy_signal(completed(parse_spec(spec).value()).value());
}
}  // namespace

TEST_CASE("settings of a signal are constants, and out of range values widen the range") {
    const auto signal = written("lissajous:x=20,points=1000,weighting=speed");
    REQUIRE(signal.has_value());
    CHECK(signal->points == 1000);
    const auto has = [&](const char* text) { return signal->text.find(text) != std::string::npos; };
    CHECK(has("const float signal_x = 20.0;  // @range 1 20 @label \"X frequency\""));
    CHECK(has("const float signal_amplitude = 0.8;  // @range 0 1 "));
    CHECK(has("const bool signal_is_weighted = true;  // @label"));
}

// The largest value of sin(x) + sin(2 x) / 2 is 3 sqrt(3) / 4 = 1.299038, at x = pi / 3.
TEST_CASE("a sum of harmonics is divided by its peak") {
    const auto signal = written("harmonics:count=2,falloff=1");
    REQUIRE(signal.has_value());
    CHECK(signal->text.find("const float signal_peak = 1.2990381") != std::string::npos);
}

TEST_CASE("other signals and too many points are refused") {
    CHECK(written("text:HELLO").error().front().message.find("the signal 'text'") == 0);
    CHECK(written("am:points=16384").has_value());
    CHECK(written("am:points=16385").error().front().message.find("16385 points") !=
          std::string::npos);
}
