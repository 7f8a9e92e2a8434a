#include "cli/common.h"
#include "lab/offline/measure.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <iostream>

namespace {
constexpr std::array bench_examples{
    "afterglow bench phosphor",
    "afterglow bench phosphor+crt --size 640x360 --frames 20",
    "afterglow bench crt --source pattern:smpte --json",
    "afterglow bench crt --generic",
};

struct BenchArguments {
    LookOptions look;
    MeasureSettings settings;
    bool as_json = false;
};

void print_json(const Measurement& measured) {
    nlohmann::ordered_json passes = nlohmann::ordered_json::array();
    for (const PassTime& pass : measured.passes)
        passes.push_back({{"name", pass.name}, {"ms", pass.milliseconds}});
    const nlohmann::ordered_json document{
        {"frame", {{"cpu_ms", measured.cpu_milliseconds}, {"wall_ms", measured.wall_milliseconds}}},
        {"passes", std::move(passes)},
        {"draw_calls", measured.draw_calls},
        {"bytes_per_pixel", measured.bytes_per_pixel},
        {"target_bytes", measured.target_bytes},
        {"renderer", measured.renderer}};
    std::cout << document.dump(2) << '\n';
}

void print_table(const Measurement& measured) {
    std::cout << fmt::format(
        "Renderer          {}\n"
        "Frame, CPU time   {:.3f} ms\n"
        "Frame, wall time  {:.3f} ms\n"
        "Draw calls        {}\n"
        "Memory traffic    {:.1f} bytes per pixel\n"
        "Render targets    {:.1f} MB\n\n",
        measured.renderer, measured.cpu_milliseconds, measured.wall_milliseconds,
        measured.draw_calls, measured.bytes_per_pixel,
        1e-6 * static_cast<double>(measured.target_bytes));
    std::cout << fmt::format("{:<24} {:>11}\n", "Pass", "GPU time");
    for (const PassTime& pass : measured.passes)
        std::cout << fmt::format("{:<24} {:>8.3f} ms\n", pass.name, pass.milliseconds);
}

int bench(const BenchArguments& arguments, const DataFolders& data) {
    const RenderRequest request = arguments.look.request();
    const auto displayed = [&](const PreparedLook&) {
        return arguments.settings.is_generic ? std::nullopt
                                             : std::optional(std::vector<std::string>());
    };
    const auto work = [&](Offline& offline, const Library&) -> Result<void> {
        const auto measured = measure(offline, arguments.settings);
        if (!measured)
            return fail(measured.error());
        arguments.as_json ? print_json(*measured) : print_table(*measured);
        return {};
    };
    return run_drawing(request, data, {{}, work, displayed});
}
}  // namespace

/// afterglow bench LOOK --json
Command add_bench(CommandLine& program) {
    Options options =
        program.add_verb("bench", "Measure the render time of a look", bench_examples);
    auto arguments = std::make_shared<BenchArguments>();
    arguments->look.add_to(options, LookOptions::Take::drawing);
    options
        .add("--frames N", arguments->settings.frames, "Number of frames to measure, after warm-up")
        .show_default()
        .between(1, 100000);
    options.add_flag("--generic", arguments->settings.is_generic,
                     "Measure the programs that draw while a value changes, instead of programs "
                     "with the values compiled in");
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders& data) { return bench(*arguments, data); };
}
