#include "lab/offline/measure.h"

#include "gpu/objects/draw.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace {
double process_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double wall_milliseconds() {
    return std::chrono::duration<double, std::milli>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double median(std::vector<double> values) {
    if (values.empty())
        return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}
}  // namespace

Result<Measurement> measure(Offline& offline, const MeasureSettings& settings) {
    constexpr int warm_up_frames = 8;
    if (auto off = offline.set_nan_policy(NanPolicy::off); !off)
        return fail(off.error());
    if (!settings.is_generic) {
        if (auto specialized = offline.specialize(); !specialized)
            return fail(specialized.error());
    }
    for (int frame = 0; frame < warm_up_frames; ++frame)
        offline.advance();
    gpu::finish();

    std::vector<double> cpu;
    std::vector<double> wall;
    const Look& look = offline.executor().look();
    std::vector<std::vector<double>> passes(look.passes.size());
    for (int frame = 0; frame < settings.frames; ++frame) {
        const double cpu_start = process_milliseconds();
        const double wall_start = wall_milliseconds();
        offline.advance();
        gpu::finish();
        cpu.push_back(process_milliseconds() - cpu_start);
        wall.push_back(wall_milliseconds() - wall_start);
        const std::vector<double> times = offline.pass_milliseconds();
        for (std::size_t i = 0; i < passes.size(); ++i)
            passes[i].push_back(times[i]);
    }

    Measurement measured;
    measured.cpu_milliseconds = median(std::move(cpu));
    measured.wall_milliseconds = median(std::move(wall));
    for (std::size_t i = 0; i < passes.size(); ++i)
        measured.passes.push_back({look.passes[i].name, median(std::move(passes[i]))});
    measured.draw_calls = offline.executor().drawer().draw_calls();
    measured.bytes_per_pixel = bytes_per_pixel(offline.executor());
    measured.target_bytes = memory_of(offline.executor().plan());
    measured.renderer = offline.context().info().renderer;
    return measured;
}
