// A flashing picture: the counts of the meter and the output of the flash limiter.
#include "gpu/objects/draw.h"
#include "gpu/objects/readback.h"
#include "graph/looks.h"
#include "lab/inspect/flash_limiter.h"
#include "lab/inspect/flash_meter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
/// A canvas of one colour, in display values, that flashes with a period in frames at 60 fps.
struct Flashing : Headless {
    std::optional<gpu::Canvas> canvas;
    std::array<float, 4> dark{0.0f, 0.0f, 0.0f, 1.0f};
    std::array<float, 4> light{1.0f, 1.0f, 1.0f, 1.0f};

    Flashing() {
        auto made = gpu::Canvas::make({96, 72}, Format::rgba8);
        REQUIRE(made.has_value());
        canvas.emplace(std::move(*made));
    }
    void draw(int frame, int period) const {
        canvas->clear(frame % period * 2 < period ? dark : light);
    }
    /// The highest counts of a meter over the frames that `shown` returns.
    template <class Shown>
    Flashes counted(int period, Shown shown) {
        std::uint64_t number = 0;
        auto cells = LightCells::make();
        REQUIRE(cells.has_value());
        FlashMeter meter(std::move(*cells));
        Flashes maximum;
        for (int frame = 0; frame < 120; ++frame) {
            draw(frame, period);
            const double seconds = frame / 60.0;
            meter.update({shown(seconds), Encoding::display, ++number}, seconds);
            gpu::finish();  // otherwise some frames might be skipped
            maximum = {std::max(maximum.general, meter.flashes().general),
                       std::max(maximum.red, meter.flashes().red)};
        }
        return maximum;
    }
};

double red_in_the_middle(const gpu::Texture& texture) {
    return static_cast<double>(gpu::read_pixel(texture, 48, 36)[0]);
}
}  // namespace

TEST_CASE_FIXTURE(Flashing, "flashes are counted from the cells of a picture") {
    const auto as_it_is = [&](double) -> const gpu::Texture& { return canvas->texture(); };
    CHECK(counted(20, as_it_is) == Flashes{3, 0});
    CHECK(counted(10, as_it_is) == Flashes{6, 0});
    // Display values 0.35 and 0.45: light of 0.1005 and 0.1706, 0.07 apart.
    dark = {0.35f, 0.35f, 0.35f, 1.0f};
    light = {0.45f, 0.45f, 0.45f, 1.0f};
    CHECK(counted(10, as_it_is) == Flashes{0, 0});
}

TEST_CASE_FIXTURE(Flashing,
                  "the limiter keeps every flash within the limit, even at its highest rate") {
    const auto limited_by = [&](double maximum) {
        auto limiter = FlashLimiter::make();
        REQUIRE(limiter.has_value());
        return [&, maximum, limiter = std::make_shared<FlashLimiter>(std::move(*limiter))](
                   double seconds) -> const gpu::Texture& {
            return limiter->shown(0, canvas->texture(), {true, maximum}, seconds);
        };
    };
    for (const int period : {2, 6, 10, 14}) {
        CHECK(counted(period, limited_by(FlashLimit::highest)).general <= 3);
        CHECK(counted(period, limited_by(FlashLimit::default_maximum)).general <= 1);
    }
    light = {1.0f, 0.0f, 0.0f, 1.0f};
    const auto as_it_is = [&](double) -> const gpu::Texture& { return canvas->texture(); };
    CHECK(counted(10, as_it_is).red == 6);
    CHECK_FALSE(counted(10, limited_by(FlashLimit::highest)).is_beyond_limit());
}

TEST_CASE_FIXTURE(Flashing, "limited light rises and falls at the chosen rate") {
    auto limiter = FlashLimiter::make();
    REQUIRE(limiter.has_value());
    const FlashLimit clamp{true, 0.3};
    canvas->clear(dark);
    limiter->shown(0, canvas->texture(), clamp, 0.0);
    canvas->clear(light);
    const gpu::Texture* limited = nullptr;
    for (int frame = 1; frame <= 60; ++frame)
        limited = &limiter->shown(0, canvas->texture(), clamp, frame / 60.0);
    // 0.3 of linear light, encoded as in IEC 61966-2-1.
    CHECK(std::abs(red_in_the_middle(*limited) - (1.055 * std::pow(0.3, 1.0 / 2.4) - 0.055)) <
          0.01);
    canvas->clear(dark);
    for (int frame = 61; frame <= 90; ++frame)
        limited = &limiter->shown(0, canvas->texture(), clamp, frame / 60.0);
    CHECK(std::abs(red_in_the_middle(*limited) - (1.055 * std::pow(0.15, 1.0 / 2.4) - 0.055)) <
          0.01);
}

TEST_CASE_FIXTURE(Flashing,
                  "a static picture is unchanged, and so is any picture without the limiter") {
    auto limiter = FlashLimiter::make();
    REQUIRE(limiter.has_value());
    canvas->clear({0.2f, 0.4f, 0.6f, 1.0f});
    const auto stored = gpu::read_pixel(canvas->texture(), 48, 36);
    for (const bool is_on : {true, false}) {
        const gpu::Texture* limited = nullptr;
        for (int frame = 0; frame < 4; ++frame)
            limited = &limiter->shown(0, canvas->texture(), {is_on, 0.3}, frame / 60.0);
        const auto pixel = gpu::read_pixel(*limited, 48, 36);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(std::abs(pixel[i] - stored[i]) <= 1.01f / 255.0f);
    }
}
