// How fast the error of "caffeine" falls, against the article's own method: RMS error of linear
// light over samples. Each method is measured against 8192 samples of its own, taken with other
// numbers; errors are those of four runs together, as most of an error can lie in a few pixels.
#include "looks/path_tracer.h"

#include <fmt/format.h>

#include <array>
#include <ctime>

namespace {
constexpr Extent size{64, 64};
constexpr int batch = 16;
constexpr std::array<int, 5> sample_counts{16, 64, 256, 512, 1024};
constexpr int runs = 4;

struct Method {
    const char* name;
    const char* pass;
    PathTracer::Settings settings;
};

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Result<PathTracer> tracer_of(const Method& method, int seed) {
    PathTracer::Settings settings = method.settings;
    settings.emplace_back("seed", std::to_string(seed));
    return PathTracer::create(std::move(settings), size, batch);
}

/// For each of the sample counts.
Result<std::vector<double>> errors_of(const Method& method) {
    auto reference = tracer_of(method, runs);
    if (!reference)
        return fail(reference.error());
    const auto right = reference->light_after(8192, method.pass);
    std::vector<double> squares(sample_counts.size());
    for (int seed = 0; seed < runs; ++seed) {
        auto tracer = tracer_of(method, seed);
        if (!tracer)
            return fail(tracer.error());
        for (std::size_t i = 0; i < sample_counts.size(); ++i)
            squares[i] +=
                mean_square_error(tracer->light_after(sample_counts[i], method.pass), right);
    }
    for (double& square : squares)
        square = std::sqrt(square / runs);
    return squares;
}

/// The error after 256 samples; 0 where there is none.
double measure(const Method& method) {
    const double start = cpu_seconds();
    const auto errors = errors_of(method);
    if (!errors) {
        fmt::print(stderr, "{}\n", to_string(errors.error()));
        return 0.0;
    }
    constexpr double samples = 8192.0 + runs * 1024.0;
    fmt::print("{:24}{:6.2f} cpu-ms a sample; rms error", method.name,
               1000.0 * (cpu_seconds() - start) / samples);
    for (std::size_t i = 0; i < sample_counts.size(); ++i)
        fmt::print("  {}: {:.5f}", sample_counts[i], (*errors)[i]);
    fmt::print("  512/1024: {:.2f}\n", (*errors)[3] / (*errors)[4]);
    return (*errors)[2];
}
}  // namespace

/// Arguments: the roughnesses to measure; without any, 0, 0.3 and 1.
int main(int count, char** arguments) {
    std::vector<std::string> chosen(arguments + 1, arguments + count);
    if (chosen.empty())
        chosen = {"0", "0.3", "1"};
    for (const std::string& roughness : chosen) {
        PathTracer::Settings scene{{"atom_roughness", roughness}, {"coffee_roughness", roughness}};
        fmt::print("roughness {}, {}x{}, the look's own scene\n", roughness, size.width,
                   size.height);
        const double ours = measure({"Afterglow", "trace", scene});
        scene.emplace_back("as_written", "true");
        const double articles = measure({"the article as written", "article", scene});
        if (ours == 0.0 || articles == 0.0)
            return 1;
        fmt::print("after 256 samples {:.2f} of the article's error\n", ours / articles);
        std::fflush(stdout);
    }
    return 0;
}
