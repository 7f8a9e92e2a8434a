#include "signals/audio/auto_gain.h"

#include "about.h"

namespace {
/// 1000 samples a second that come in as time goes by: quiet, and from sample 1050 on loud.
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

TEST_CASE("the gain of a live sound looks only at tenths of a second that are whole") {
    Incoming sound;
    const AutoGain gain(sound);
    const auto gain_at = [&](std::int64_t now) {
        sound.heard = now;  // nothing later has come in yet
        return gain.at(static_cast<double>(now));
    };
    for (std::int64_t now = 0; now < 1100; now += 10)
        (void)gain_at(now);
    CHECK(gain_at(1100) == about(1.0 / 0.1, 1e-3));  // not yet seen
    for (std::int64_t now = 1110; now < 1300; now += 10)
        (void)gain_at(now);
    CHECK(gain_at(1300) == about(1.0 / 0.8, 1e-3));  // the tenth with its first half quiet is known
}
