#include "bench/figure.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace bench {

namespace {
constexpr double min_idle = 0.92;

const char* text_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::miss:
            return "miss";
        case Verdict::noise:
            return "noise";
        case Verdict::none:
            break;
    }
    return "";
}

std::string text_of(const Bound& bound) {
    return fmt::format("{} {:.4g}", bound.side == Bound::Side::at_most ? "at most" : "at least",
                       bound.value);
}

std::string digits_of(double value) {
    const double size = std::abs(value);
    const int decimals = size == 0.0 ? 0 : size < 0.1 ? 4 : size < 10.0 ? 3 : size < 100.0 ? 1 : 0;
    return fmt::format("{:.{}f}", value, decimals);
}

void write_line(const nlohmann::ordered_json& line) {
    const char* file = std::getenv("AFTERGLOW_BENCH_FIGURES");
    if (!file)
        return;
    std::ofstream stream(file, std::ios::app);
    stream << line.dump() + "\n";
    stream.close();
    if (stream)
        return;
    std::perror(file);
    std::exit(EXIT_FAILURE);
}
}  // namespace

Verdict verdict_of(const Figure& figure) {
    if ((figure.itself && !is_itself(*figure.itself)) ||
        (figure.idle && !(*figure.idle >= min_idle)))
        return Verdict::noise;
    if (!figure.bound)
        return Verdict::none;
    const bool is_met = figure.bound->side == Bound::Side::at_most
                            ? figure.value <= figure.bound->value
                            : figure.value >= figure.bound->value;
    return is_met ? Verdict::pass : Verdict::miss;
}

void tell(const Topic& topic, const Figure& figure) {
    if (!std::isfinite(figure.value)) {
        fmt::print(stderr, "{}/{}: not a finite number\n", topic.key, figure.key);
        std::exit(EXIT_FAILURE);
    }
    const char* verdict = text_of(verdict_of(figure));
    std::string line =
        fmt::format("  {:<72} {:>8} {:<8} {:<17} {:<14}", figure.what, digits_of(figure.value),
                    figure.unit, figure.bound ? text_of(*figure.bound) : "", verdict);
    if (figure.itself)
        line += fmt::format(" reference noise {:.3f}", *figure.itself);
    if (figure.idle)
        line += fmt::format(" {:.0f} % idle before", 100.0 * *figure.idle);
    if (!figure.detail.empty())
        line += " (" + figure.detail + ")";
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    std::fflush(stdout);

    nlohmann::ordered_json told{{"topic", topic.key},    {"title", topic.title},
                                {"key", figure.key},     {"what", figure.what},
                                {"value", figure.value}, {"unit", figure.unit}};
    if (figure.bound)
        told[figure.bound->side == Bound::Side::at_most ? "at_most" : "at_least"] =
            figure.bound->value;
    if (figure.itself)
        told["itself"] = *figure.itself;
    if (figure.idle)
        told["idle"] = *figure.idle;
    told["detail"] = figure.detail;
    told["verdict"] = verdict;
    write_line(told);
}

void tell_driver(const gpu::DriverInfo& info) {
    write_line({{"driver", info.renderer + ", OpenGL " + info.version}});
}

}  // namespace bench
