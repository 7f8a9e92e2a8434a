// Cost of a picture that a match of a photo draws, with other values each time, compared with a
// frame of `afterglow bench` at the same size.
#include "bench/side_by_side.h"
#include "bench/wanted.h"
#include "lab/match/screen_renderer.h"

#include <cstdlib>
#include <utility>

namespace {
const bench::Topic topic{"match", "Matching a photo with shadow-mask"};

constexpr Extent size{1280, 960};

PreparedLook prepared() {
    RenderRequest request;
    request.look = "shadow-mask";
    request.source = "pattern:harbour";
    request.size = size;
    const Library library(bench::wanted(find_roots(AFTERGLOW_SOURCE_DIR)));
    return bench::wanted(prepare(request, library));
}

// The picture of a fit: other values, and the light at the samples.
class Matcher {
public:
    Matcher()
        : m_renderer(bench::wanted(
              ScreenRenderer::create(prepared(), size,
                                     {"mask_strength", "mask_size", "curvature",
                                      "scanline_strength", "bloom_intensity", "bloom_radius"}))) {
        for (const Parameter& parameter : m_renderer.look().parameters)
            m_values[parameter.name] = parameter.initial;
    }
    void draw() {
        m_renderer.make_current();
        double& strength = m_values.at("mask_strength").numbers.front();
        strength = strength < 0.5 ? strength + 0.001 : 0.1;
        bench::wanted(m_renderer.light(m_values));
    }

private:
    ScreenRenderer m_renderer;
    Values m_values;
};
}  // namespace

int main() {
    constexpr double seconds = 20.0;
    Offline frames = bench::wanted(Offline::create(prepared(), size, 60.0));
    if (auto off = frames.set_nan_policy(NanPolicy::off); !off)
        bench::give_up(off.error());
    if (auto specialized = frames.specialize(); !specialized)
        bench::give_up(specialized.error());
    Matcher matcher;
    const bench::Cost cost = bench::side_by_side_for(
        seconds,
        [&frames] {
            frames.make_current();
            frames.advance();
        },
        [&matcher] { matcher.draw(); });
    bench::tell(topic, bench::ratio_figure("picture",
                                           "a picture with other values, read at its samples: CPU "
                                           "time / frame of bench",
                                           cost, bench::at_most(1.5)));
    return EXIT_SUCCESS;
}
