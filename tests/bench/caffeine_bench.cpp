// How much sooner "caffeine" is as clean as the article's own method. Errors: RMS over samples of
// linear light and of what a display shows (clamped, gamma 2.2), each method against 8192 samples
// of its own, taken with other numbers; of four runs together, as most of an error can lie in a few
// pixels. The article's light is not ours: its darks are brighter, where a display's curve is
// steep, so errors on a display are printed but not held against each other. Time: both side by
// side.
#include "bench/side_by_side.h"
#include "looks/path_tracer.h"

#include <fmt/format.h>

#include <array>

namespace {
constexpr Extent error_size{64, 64};
constexpr Extent speed_size{256, 256};
constexpr int batch = 16;
constexpr std::array<int, 5> sample_counts{16, 64, 256, 512, 1024};
constexpr int runs = 4;

struct Method {
    const char* name;
    const char* pass;
    PathTracer::Settings settings;
};

Result<PathTracer> tracer_of(const Method& method, int seed, Extent size) {
    PathTracer::Settings settings = method.settings;
    settings.emplace_back("seed", std::to_string(seed));
    return PathTracer::create(std::move(settings), size, batch);
}

/// After each of the sample counts.
using Errors = std::array<double, sample_counts.size()>;
struct Measured {
    Errors light{};
    Errors display{};
};

std::vector<double> displayed(std::vector<double> light) {
    for (double& value : light)
        value = std::pow(std::clamp(value, 0.0, 1.0), 1.0 / 2.2);
    return light;
}

Result<Measured> errors_of(const Method& method) {
    auto reference = tracer_of(method, runs, error_size);
    if (!reference)
        return fail(reference.error());
    const auto right = reference->light_after(8192, method.pass);
    const auto right_display = displayed(right);
    Measured squares;
    for (int seed = 0; seed < runs; ++seed) {
        auto tracer = tracer_of(method, seed, error_size);
        if (!tracer)
            return fail(tracer.error());
        for (std::size_t i = 0; i < sample_counts.size(); ++i) {
            const auto light = tracer->light_after(sample_counts[i], method.pass);
            squares.light[i] += mean_square_error(light, right);
            squares.display[i] += mean_square_error(displayed(light), right_display);
        }
    }
    for (Errors* errors : {&squares.light, &squares.display})
        for (double& square : *errors)
            square = std::sqrt(square / runs);
    return squares;
}

/// The samples after which errors that fall by a power between two counts come down to `error`.
double samples_until(const Errors& errors, double error) {
    std::size_t i = 1;
    while (i + 1 < errors.size() && errors[i] > error)
        ++i;
    const double from = std::log(sample_counts[i - 1]);
    const double to = std::log(sample_counts[i]);
    const double fall = std::log(errors[i - 1] / errors[i]);
    return std::exp(from + (to - from) * std::log(errors[i - 1] / error) / fall);
}

/// Ours to the article's, the article's own method being the yardstick.
Result<bench::Cost> cost_of(const Method& ours, const Method& articles) {
    auto plain = tracer_of(articles, 0, speed_size);
    auto own = tracer_of(ours, 0, speed_size);
    for (const auto* tracer : {&plain, &own})
        if (!*tracer)
            return fail(tracer->error());
    for (PathTracer* tracer : {&*plain, &*own})
        if (auto done = tracer->settle(); !done)
            return fail(done.error());
    constexpr int rounds = 7;
    constexpr int frames = 2;
    return bench::side_by_side(
        rounds, frames, [&] { plain->advance(); }, [&] { own->advance(); });
}

void print(const char* name, const char* what, const Errors& errors) {
    fmt::print("{:24}{:8}", name, what);
    for (std::size_t i = 0; i < errors.size(); ++i)
        fmt::print("  {}: {:.5f}", sample_counts[i], errors[i]);
    fmt::print("  512/1024: {:.2f}\n", errors[3] / errors[4]);
}

struct Bound {
    const char* what;
    double value;
    double least;
};

bool holds(const Bound& bound) {
    const bool is_met = bound.value >= bound.least;
    fmt::print("{}: {:.2f}, at least {}: {}\n", bound.what, bound.value, bound.least,
               is_met ? "met" : "MISSED");
    return is_met;
}

bool compare(const Measured& ours, const Measured& articles, const bench::Cost& cost) {
    const auto sooner = [&](const Errors& own, const Errors& other, std::size_t after) {
        return sample_counts[after] / samples_until(own, other[after]) / cost.ratio;
    };
    const std::array bounds{Bound{"sooner at the article's error after 64 samples",
                                  sooner(ours.light, articles.light, 1), 4.5},
                            Bound{"sooner at the article's error after 256 samples",
                                  sooner(ours.light, articles.light, 2), 6.0},
                            Bound{"the article's error after 256 samples to ours",
                                  articles.light[2] / ours.light[2], 1.0 / 0.45},
                            Bound{"our error after 512 samples to that after 1024",
                                  ours.light[3] / ours.light[4], 1.35}};
    return std::ranges::count_if(bounds, holds) == static_cast<std::ptrdiff_t>(bounds.size());
}

/// Whether it could be measured and all bounds hold.
Result<bool> measure(const std::string& roughness) {
    PathTracer::Settings scene{{"atom_roughness", roughness}, {"coffee_roughness", roughness}};
    const Method ours{"Afterglow", "trace", scene};
    scene.emplace_back("as_written", "true");
    const Method articles{"the article as written", "article", scene};
    const auto cost = cost_of(ours, articles);
    if (!cost)
        return fail(cost.error());
    fmt::print(
        "roughness {}: {:.2f} cpu-ms a sample of {}x{} px, the article {:.2f}, ratio {:.3f}, "
        "the article to itself {:.3f}{}\n",
        roughness, cost->our_milliseconds / batch, speed_size.width, speed_size.height,
        cost->plain_milliseconds / batch, cost->ratio, cost->itself,
        cost->counts() ? "" : " (does not count)");
    const auto own = errors_of(ours);
    if (!own)
        return fail(own.error());
    const auto other = errors_of(articles);
    if (!other)
        return fail(other.error());
    print(ours.name, "light", own->light);
    print(articles.name, "light", other->light);
    print(ours.name, "display", own->display);
    print(articles.name, "display", other->display);
    const bool holds = compare(*own, *other, *cost);
    std::fflush(stdout);
    return holds;
}
}  // namespace

/// Arguments: the roughnesses to measure; without any, 0, 0.3 and 1.
int main(int count, char** arguments) {
    std::vector<std::string> chosen(arguments + 1, arguments + count);
    if (chosen.empty())
        chosen = {"0", "0.3", "1"};
    bool is_met = true;
    for (const std::string& roughness : chosen) {
        const auto done = measure(roughness);
        if (!done)
            fmt::print(stderr, "{}\n", to_string(done.error()));
        is_met = is_met && done && *done;
    }
    return is_met ? 0 : 1;
}
