// Cost of a beam by its number of samples: generating, merging, uploading and drawing them. The
// reference is a plain GL program that draws each sample (bench/plain_beam.h). Pictures are
// compared before times.
#include "bench/plain_beam.h"
#include "bench/side_by_side.h"
#include "bench/wanted.h"
#include "gpu/headless_context.h"
#include "gpu/objects/readback.h"
#include "graph/beam/merge_segments.h"
#include "graph/programs/specialized_look.h"
#include "lab/offline/offline.h"

#include <fmt/format.h>

#include <cstdlib>

namespace {
constexpr Extent screen{1280, 720};
constexpr double spot_px = 1.0;
const bench::Topic topic{"beam", "Vector beam with many samples, Lissajous figure 5:4, 1280 x 720"};
using bench::Bound;
using bench::Figure;
using bench::wanted;

/// Only the first pass of Vector beam, specialised.
class OurBeam {
public:
    explicit OurBeam(int samples) : m_prepared(prepared(samples)), m_executor(made(m_prepared)) {
        wanted(m_player.set_signal(m_prepared.document.state().signal));
        wanted(m_executor.resize(screen, screen));
        m_executor.set_values(m_prepared.document.values());
        std::vector<PassRun> runs(m_executor.look().passes.size(), PassRun::left_out);
        runs.front() = PassRun::drawn;
        wanted(m_executor.set_runs(std::move(runs)));
    }

    /// The next frame, preceded by its own last point: the figure is closed.
    Beam closed() {
        Beam beam = samples();
        beam.insert(beam.begin(), beam.back());
        return beam;
    }
    Beam samples() {
        m_frame = m_player.advance_fixed(60.0);
        return m_player.signal().trace(m_frame.span);
    }
    void draw() {
        const Beam beam = samples();
        Frame frame;
        frame.number = m_frame.number;
        frame.time = m_frame.span.end;
        frame.time_delta = m_frame.span.seconds();
        frame.is_first = m_frame.number == 1;
        frame.beam = beam;
        m_executor.draw(frame);
    }
    Picture picture() const { return gpu::read_picture(m_executor.target(0)); }

private:
    static PreparedLook prepared(int samples) {
        RenderRequest request;
        request.look = "vector-beam";
        request.size = screen;
        request.signal = fmt::format("lissajous:x=5,y=4,amplitude=0.84,points={}", samples);
        request.values = {{"spot_sigma", fmt::format("{}", spot_px * 512.0 / screen.height)},
                          {"spot_growth", "0"},
                          {"screen_size", "1"},
                          {"fit", "1"}};
        const Library library(wanted(find_roots(AFTERGLOW_SOURCE_DIR)));
        return wanted(prepare(request, library));
    }
    static Executor made(const PreparedLook& prepared) {
        const Look& look = prepared.document.look();
        const Values& values = prepared.document.values();
        const Plan plan = wanted(plan_targets(look, screen, {}, values));
        SpecializedTexts texts;
        const Look specialized = specialized_look(
            look, values, plan, [](const Parameter&) { return false; }, texts);
        return Executor(look, wanted(build_programs(specialized)));
    }

    PreparedLook m_prepared;
    Executor m_executor;
    Player m_player;
    PlayedFrame m_frame;
};

double sum_of(const Picture& picture, std::size_t channel) {
    double sum = 0.0;
    for (std::size_t i = channel; i < picture.pixels.size(); i += 4)
        sum += static_cast<double>(picture.pixels[i]);
    return sum;
}

// The program's light is in green. Both pictures are scaled to the same total light.
double root_mean_square(const Picture& plain, const Picture& ours) {
    const double scale = sum_of(plain, 0) / sum_of(ours, 1);
    double difference = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < plain.pixels.size(); i += 4) {
        const auto light = static_cast<double>(plain.pixels[i]);
        difference += std::pow(scale * static_cast<double>(ours.pixels[i + 1]) - light, 2);
        all += light * light;
    }
    return std::sqrt(difference / all);
}

/// Milliseconds of CPU time.
struct Parts {
    double making = 0.0;
    double merging = 0.0;
    std::size_t segments = 0;
};

Parts parts_of(OurBeam& beam) {
    const BeamSpot spot{2.0 * spot_px / screen.width, 2.0 * spot_px / screen.height};
    std::vector<double> making;
    std::vector<double> merging;
    std::vector<Segment> segments;
    SegmentTints none;
    for (int i = 0; i < 9; ++i) {
        const double start = bench::busy_seconds();
        const Beam samples = beam.samples();
        const double between = bench::busy_seconds();
        make_segments(samples, std::nullopt, segments, none);
        merge_segments(segments, none, spot);
        making.push_back(1e3 * (between - start));
        merging.push_back(1e3 * (bench::busy_seconds() - between));
    }
    return {bench::median(making), bench::median(merging), segments.size()};
}

void compare_with_plain(int samples, std::optional<Bound> bound) {
    constexpr double seconds = 5.0;
    OurBeam ours(samples);
    auto plain = wanted(bench::PlainBeam::make(screen, spot_px));
    for (int i = 0; i < 2; ++i) {  // the first frame has no previous sample
        plain.draw(ours.closed());
        ours.draw();
    }
    const double apart = root_mean_square(plain.picture(), ours.picture());
    const Parts parts = parts_of(ours);
    bench::tell(topic, {.key = fmt::format("apart-{}", samples),
                        .what = fmt::format(
                            "{} samples: RMS difference between merged and all samples", samples),
                        .value = 100.0 * apart,
                        .unit = "%",
                        .bound = bench::at_most(1.0),
                        .detail = fmt::format("{} segments", parts.segments)});
    Figure cost = bench::ratio_figure(
        fmt::format("merged-{}", samples),
        fmt::format("{} samples merged: CPU time relative to one rectangle per sample", samples),
        bench::side_by_side_for(
            seconds, [&] { plain.draw(ours.closed()); }, [&] { ours.draw(); }),
        bound);
    cost.detail +=
        fmt::format("; samples {:.3g} ms, merging {:.3g} ms", parts.making, parts.merging);
    bench::tell(topic, cost);
}

void tell_growth(int few, int many, double maximum) {
    constexpr double seconds = 5.0;
    OurBeam yardstick(few);
    OurBeam ours(many);
    bench::tell(topic, bench::ratio_figure(
                           fmt::format("growth-{}", many),
                           fmt::format("{} samples: CPU time relative to {} samples", many, few),
                           bench::side_by_side_for(
                               seconds, [&] { yardstick.draw(); }, [&] { ours.draw(); }),
                           bench::at_most(maximum)));
}
}  // namespace

int main() {
    const auto context = wanted(gpu::create_headless_context());
    bench::tell_driver(context->info());
    for (const int samples : {4096, 16384, 65536})
        compare_with_plain(samples, {});
    compare_with_plain(262144, bench::at_most(1.0 / 15.0));
    for (const int samples : {16384, 65536, 262144})
        tell_growth(4096, samples, 5.0);
    return EXIT_SUCCESS;
}
