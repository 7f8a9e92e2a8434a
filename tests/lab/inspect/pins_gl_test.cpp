#include "gpu/objects/draw.h"
#include "lab/inspect/pins.h"
#include "lab/small_lab.h"

TEST_CASE("a pin reads its point in every pass, at most five times per second") {
    SmallLab small;
    small.lab().player().pause();
    small.update(2);
    const Executor& executor = small.lab().renderer()->executor();
    const auto current = [&] { return gpu::read_pixel(executor.target(0), 0, 0)[0]; };
    auto pins = Pins::make();
    REQUIRE(pins.has_value());
    std::vector<Pin> pinned{{0.5, 0.5}};
    const auto look = [&](double seconds) {
        for (int i = 0; i < 3; ++i) {
            pins->update(executor, pinned, seconds);
            gpu::finish();
        }
    };
    look(1000.0);
    REQUIRE(pins->value(0, 1));
    const float first = current();
    CHECK((*pins->value(0, 0))[0] == first);
    CHECK((*pins->value(0, 1))[0] == first);  // the gain is 1
    CHECK(pins->value(0, 2) == nullptr);
    CHECK(pins->value(1, 0) == nullptr);

    small.lab().player().step();
    small.update(1);
    REQUIRE(current() == first + 1.0f);
    look(1000.19);
    CHECK((*pins->value(0, 0))[0] == first);
    look(1001.0);
    CHECK((*pins->value(0, 0))[0] == first + 1.0f);

    pinned.push_back({0.0, 1.0});
    look(1001.01);  // at once, because the pins changed
    REQUIRE(pins->value(1, 1));
    pins->stop();
    CHECK(pins->value(0, 0) == nullptr);
}
