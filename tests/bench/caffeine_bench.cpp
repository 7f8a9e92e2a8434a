// How much faster Caffeine reaches the error of the article's method. Errors are the RMS of linear
// light and of displayed values (clamped, gamma 2.2). Each method is compared with 8192 of its own
// samples with other random numbers. Errors are averaged over four runs, because a few pixels can
// contribute most of an error. The article's dark areas are brighter, and a display's curve is
// steep in the dark. The same light error is therefore larger on a display for Caffeine. Times are
// measured in alternation.
#include "bench/side_by_side.h"
#include "bench/wanted.h"
#include "looks/path_tracer.h"

#include <fmt/format.h>

#include <array>

namespace {
constexpr Extent error_size{64, 64};
constexpr Extent speed_size{256, 256};
constexpr int batch = 16;
constexpr std::array<int, 5> sample_counts{16, 64, 256, 512, 1024};
constexpr int runs = 4;

const bench::Topic topic{"caffeine", "Path tracer: Caffeine compared with the article's method"};

struct Method {
    const char* pass;
    PathTracer::Settings settings;
};

Result<PathTracer> tracer_of(const Method& method, int seed, Extent size) {
    PathTracer::Settings settings = method.settings;
    settings.emplace_back("seed", std::to_string(seed));
    return PathTracer::create(std::move(settings), size, batch);
}

/// The error at each of the sample counts.
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

/// The number of samples at which the error reaches `error`, interpolated by a power law.
double samples_until(const Errors& errors, double error) {
    std::size_t i = 1;
    while (i + 1 < errors.size() && errors[i] > error)
        ++i;
    const double from = std::log(sample_counts[i - 1]);
    const double to = std::log(sample_counts[i]);
    const double fall = std::log(errors[i - 1] / errors[i]);
    return std::exp(from + (to - from) * std::log(errors[i - 1] / error) / fall);
}

/// Cost of our method relative to the article's method, which is the reference.
Result<bench::Cost> cost_of(const Method& ours, const Method& articles) {
    auto plain = tracer_of(articles, 0, speed_size);
    auto own = tracer_of(ours, 0, speed_size);
    for (const auto* tracer : {&plain, &own})
        if (!*tracer)
            return fail(tracer->error());
    for (PathTracer* tracer : {&*plain, &*own})
        if (auto done = tracer->specialize(); !done)
            return fail(done.error());
    constexpr double seconds = 15.0;
    return bench::side_by_side_for(
        seconds, [&] { plain->advance(); }, [&] { own->advance(); });
}

/// Reports the figures of one roughness of both materials.
class Telling {
public:
    Telling(std::string roughness, const bench::Cost& cost)
        : m_roughness(std::move(roughness)), m_cost(cost) {}

    void tell_errors(const char* what, const Errors& ours, const Errors& articles,
                     std::size_t after, std::optional<bench::Bound> bound) const {
        tell(fmt::format("{}-{}", what, sample_counts[after]),
             fmt::format("{} error after {} samples, relative to the article", what,
                         sample_counts[after]),
             ours[after] / articles[after], bound,
             fmt::format("{:.4f}, article {:.4f}; after {} samples", fmt::join(ours, " "),
                         fmt::join(articles, " "), fmt::join(sample_counts, ", ")));
    }
    void tell_sooner(const char* what, const Errors& ours, const Errors& articles,
                     std::size_t after, std::optional<bench::Bound> bound) const {
        bench::Figure figure = figure_of(
            fmt::format("sooner-{}-{}", what, sample_counts[after]),
            fmt::format("speed-up to reach the article's {} error after {} samples", what,
                        sample_counts[after]),
            sample_counts[after] / samples_until(ours, articles[after]) / m_cost.ratio, bound);
        figure.itself = m_cost.itself;
        figure.unit = "times";
        bench::tell(topic, figure);
    }
    void tell(const std::string& key, const std::string& what, double value,
              std::optional<bench::Bound> bound, const std::string& detail = {}) const {
        bench::Figure figure = figure_of(key, what, value, bound);
        figure.detail = detail;
        bench::tell(topic, figure);
    }

private:
    bench::Figure figure_of(const std::string& key, const std::string& what, double value,
                            std::optional<bench::Bound> bound) const {
        return {.key = fmt::format("{}-{}", m_roughness, key),
                .what = fmt::format("roughness {}: {}", m_roughness, what),
                .value = value,
                .bound = bound};
    }
    std::string m_roughness;
    bench::Cost m_cost;
};

std::optional<bench::Bound> held(bool is_held, bench::Bound bound) {
    return is_held ? std::optional(bound) : std::nullopt;
}

void tell_all(const std::string& roughness, const bench::Cost& cost, const Measured& ours,
              const Measured& articles) {
    bench::tell(
        topic,
        bench::ratio_figure(
            roughness + "-cost",
            fmt::format(
                "roughness {}: CPU time of {} samples of {} x {} px, relative to the article",
                roughness, batch, speed_size.width, speed_size.height),
            cost));
    const Telling telling(roughness, cost);
    telling.tell_sooner("light", ours.light, articles.light, 1, bench::at_least(4.5));
    telling.tell_sooner("light", ours.light, articles.light, 2, bench::at_least(6.0));
    telling.tell_sooner("display", ours.display, articles.display, 2,
                        held(roughness == "0", bench::at_least(4.0)));
    telling.tell_errors("light", ours.light, articles.light, 2, bench::at_most(0.45));
    telling.tell_errors("display", ours.display, articles.display, 4,
                        held(roughness == "0.3", bench::at_most(0.5)));
    telling.tell("fall", "light error after 512 samples relative to 1024 samples",
                 ours.light[3] / ours.light[4], bench::at_least(1.35));
}

Result<void> measure(const std::string& roughness) {
    PathTracer::Settings scene{{"atom_roughness", roughness}, {"coffee_roughness", roughness}};
    const Method ours{"trace", scene};
    scene.emplace_back("as_written", "true");
    const Method articles{"article", scene};
    const auto cost = cost_of(ours, articles);
    if (!cost)
        return fail(cost.error());
    const auto own = errors_of(ours);
    if (!own)
        return fail(own.error());
    const auto other = errors_of(articles);
    if (!other)
        return fail(other.error());
    tell_all(roughness, *cost, *own, *other);
    return {};
}
}  // namespace

/// Arguments: the roughnesses to measure; without arguments, 0 and 0.3.
int main(int count, char** arguments) {
    std::vector<std::string> chosen(arguments + 1, arguments + count);
    if (chosen.empty())
        chosen = {"0", "0.3"};
    for (const std::string& roughness : chosen)
        bench::wanted(measure(roughness));
    return EXIT_SUCCESS;
}
