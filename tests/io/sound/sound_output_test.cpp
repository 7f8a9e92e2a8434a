#include "io/sound/sound_output.h"

#include "io/captured_errors.h"

#include <doctest/doctest.h>

TEST_CASE("opening the audio device gives a device or one error, and prints nothing to stderr") {
    CapturedErrors errors;
    const auto output = open_sound_output({});
    CHECK(errors.text() == "");
    if (output) {
        CHECK_FALSE((*output)->device_name().empty());
        CHECK((*output)->position_seconds() == 0.0);
    } else {
        REQUIRE(output.error().size() == 1);
        CHECK(output.error().front().message.find("audio device") != std::string::npos);
    }
}
