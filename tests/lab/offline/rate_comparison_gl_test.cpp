#include "lab/offline/rate_comparison.h"
#include "lab/small_lab.h"

#include <cmath>

namespace {
constexpr const char* fading = R"(#version 410 core
uniform sampler2D previous;
uniform float decay = 0.5;  // @range 0 1  @unit "per 1/60 s"
uniform float u_time_delta;
uniform int u_frame;
in vec2 uv;
out vec4 color;
void main() {
    color = vec4(u_frame == 1 ? KEPT_FIRST : texture(previous, uv).r * KEPT);
}
)";

/// A lab with a fading light: factor `kept` per frame, starting with `kept_first` in frame 1.
class FadingLab : public SmallLab {
public:
    FadingLab(const std::string& kept, const std::string& kept_first) {
        std::string text = replaced(fading, "KEPT_FIRST", kept_first);
        write_by_rename("sum.frag", replaced(text, "KEPT", kept));
        REQUIRE(update_until([&] { return find_parameter(document().look(), "decay"); }));
    }
    Result<RateComparison> compare() {
        JobProgress work;
        Document document = this->document();
        document.set_value("decay", Value(0.95));
        auto found = compare_rates(document, {8, 6}, work);
        CHECK(work.share == 1.0);
        return found;
    }
};
}  // namespace

TEST_CASE("looks are compared at a time when a frame of every rate ends") {
    Look look;
    look.settle_frames = 20;  // 1/3 s; the minimum is half a second
    CHECK(comparison_seconds(look) == 0.5);
    look.settle_frames = 121;
    CHECK(std::abs(comparison_seconds(look) - 13.0 / 6.0) < 1e-12);
    for (const double fps : compared_rates)
        CHECK(std::abs(std::remainder(comparison_seconds(look) * fps, 1.0)) < 1e-9);
    look.settle_frames = 100000;
    CHECK(comparison_seconds(look) == 10.0);
    CHECK(size_to_compare({1920, 1080}) == Extent{640, 360});
    CHECK(size_to_compare({320, 200}) == Extent{320, 200});
}

TEST_CASE("a decay per second is equal at every rate") {
    FadingLab lab("pow(decay, 60.0 * u_time_delta)", "pow(decay, 60.0 * u_time_delta)");
    const auto found = lab.compare();
    REQUIRE(found.has_value());
    CHECK(found->size == Extent{8, 6});
    CHECK(found->pairs.size() == 6);
    CHECK(found->worst().difference.largest < 1e-4);
}

TEST_CASE("a decay per frame differs, and the most different rates are reported") {
    FadingLab lab("decay", "decay");
    const auto found = lab.compare();
    REQUIRE(found.has_value());
    CHECK(found->worst().first == 24.0);
    CHECK(found->worst().second == 144.0);
    // After half a second: 12 and 72 frames.
    const double apart = std::pow(0.95, 12.0) - std::pow(0.95, 72.0);
    CHECK(std::abs(found->worst().difference.largest - apart) < 1e-4);
    REQUIRE(found->pictures.size() == compared_rates.size());
    CHECK(std::abs(found->picture(24.0).pixels[0] - std::pow(0.95, 12.0)) < 1e-4);
    CHECK(std::abs(found->picture(144.0).pixels[0] - std::pow(0.95, 72.0)) < 1e-4);
}

TEST_CASE("a rate comparison runs in the background and can be cancelled and restarted") {
    FadingLab lab("decay", "1.0");
    lab.lab().jobs().compare_rates();
    CHECK(lab.lab().jobs().rates().is_running());
    lab.lab().jobs().cancel_rates();
    CHECK_FALSE(lab.lab().jobs().rates().is_running());
    lab.lab().jobs().compare_rates();
    REQUIRE(lab.update_until([&] { return !lab.lab().jobs().rates().is_running(); }));
    REQUIRE(lab.lab().jobs().rates().outcome());
    REQUIRE(lab.lab().jobs().rates().outcome()->has_value());
    const RateComparison& found = **lab.lab().jobs().rates().outcome();
    REQUIRE(lab.lab().jobs().rate_pictures().shown());
    CHECK(lab.lab().jobs().rate_pictures().shown()->pair == found.worst_index());
    lab.lab().jobs().show_rate_pair(0);
    CHECK(lab.lab().jobs().rate_pictures().shown()->pair == 0);
    CHECK(lab.lab().jobs().rate_pictures().shown()->gain ==
          gain_to_see(found.pairs[0].difference.largest));
}
