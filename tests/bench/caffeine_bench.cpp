// How fast the error of "caffeine" falls, against the article's own method: RMS error of linear
// light over samples. Each method is measured against 8192 samples of its own, taken with other
// numbers.
#include "looks/path_tracer.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

namespace {
constexpr Extent size{64, 64};
constexpr int batch = 16;

struct Method {
    const char* name;
    const char* pass;
    PathTracer::Settings settings;
};

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Result<std::vector<double>> reference_of(const Method& method) {
    PathTracer::Settings other = method.settings;
    other.emplace_back("seed", "1");
    auto tracer = PathTracer::create(other, size, batch);
    if (!tracer)
        return fail(tracer.error());
    const double start = cpu_seconds();
    auto light = tracer->light_after(8192, method.pass);
    fmt::print("{:24}{:6.2f} cpu-ms a sample; rms error", method.name,
               1000.0 * (cpu_seconds() - start) / 8192.0);
    return light;
}

int measure(const Method& method) {
    const auto right = reference_of(method);
    auto tracer = PathTracer::create(method.settings, size, batch);
    if (!right || !tracer) {
        fmt::print(stderr, "{}\n", to_string(right ? tracer.error() : right.error()));
        return 1;
    }
    double before = 0.0;
    for (const int samples : {16, 64, 256, 512, 1024}) {
        const double error =
            root_mean_square_error(tracer->light_after(samples, method.pass), *right);
        fmt::print("  {}: {:.5f}", samples, error);
        if (samples == 1024)
            fmt::print("  512/1024: {:.2f}", before / error);
        before = error;
    }
    fmt::print("\n");
    return 0;
}
}  // namespace

int main() {
    int failed = 0;
    for (const char* roughness : {"0", "0.3", "1"}) {
        PathTracer::Settings scene{{"atom_roughness", roughness}, {"coffee_roughness", roughness}};
        fmt::print("roughness {}, {}x{}, the look's own scene\n", roughness, size.width,
                   size.height);
        failed += measure({"Afterglow", "trace", scene});
        scene.emplace_back("as_written", "true");
        failed += measure({"the article as written", "article", scene});
    }
    return failed;
}
