#include "signals/audio/auto_gain.h"

#include "about.h"

namespace {
/// A live sound with 1000 samples per second: quiet, and loud from sample 1050.
class Incoming : public SampleStream {
public:
    int rate() const override { return 1000; }
    std::int64_t length() const override { return endless; }
    bool loops() const override { return false; }
    bool is_live() const override { return true; }
    void read(std::int64_t first, std::span<StereoSample> samples) const override {
        for (StereoSample& sample : samples) {
            const float level = first >= 1050 ? 0.8f : 0.1f;
            sample = first < heard && first >= 0 ? StereoSample{level, 0.0f} : StereoSample{};
            ++first;
        }
    }

    std::int64_t heard = 0;
};
}  // namespace

TEST_CASE("the gain of a live sound uses only complete tenths of a second") {
    Incoming sound;
    const AutoGain gain(sound);
    const auto gain_at = [&](std::int64_t now) {
        sound.heard = now;  // later samples do not exist yet
        return gain.at(static_cast<double>(now));
    };
    for (std::int64_t now = 0; now < 1100; now += 10)
        (void)gain_at(now);
    CHECK(gain_at(1100) == about(1.0 / 0.1, 1e-3));  // not counted yet
    for (std::int64_t now = 1110; now < 1300; now += 10)
        (void)gain_at(now);
    CHECK(gain_at(1300) == about(1.0 / 0.8, 1e-3));  // the half loud block is complete
}
