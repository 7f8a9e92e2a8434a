// libretro presets compared with a plain chain of the GL calls that RetroArch's rules require
// (tests/parity/). `cost FILE...`, or without arguments some presets of AFTERGLOW_SLANG_DIR: the
// cost of a frame. `pictures FILE_OR_FOLDER...`: the difference of the pictures, one line of JSON
// per preset, each in its own process, as shaders crash some drivers.
#include "bench/side_by_side.h"
#include "io/system/child_process.h"
#include "lab/offline/corpus.h"
#include "parity/moving_picture.h"
#include "parity/pair.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace fs = std::filesystem;

namespace {
constexpr Extent original{320, 240};

const bench::Topic topic{"slang", "libretro presets, source 320 x 240, compared with plain GL"};
using bench::Cost;

Cost cost_of(plain::Pair& pair) {
    constexpr int rounds = 5;
    constexpr double min_seconds = 0.1;
    const auto plain = [&] { pair.draw_plain(); };
    bench::seconds_of(4, plain);  // the first frames compile
    const int frames = static_cast<int>(min_seconds / (bench::seconds_of(4, plain) / 4)) + 1;
    return bench::side_by_side(rounds, frames, plain, [&] { pair.draw_ours(); });
}

Result<Cost> cost_once(const fs::path& preset, Extent viewport) {
    auto pair = plain::Pair::open(preset, original, viewport);
    if (!pair)
        return fail(pair.error());
    if (auto set = pair->set_original(plain::moving_picture(original, 0)); !set)
        return fail(set.error());
    return cost_of(*pair);
}

bool measure_cost(const fs::path& preset, Extent viewport) {
    constexpr int openings = 5;
    std::vector<Cost> costs;
    for (int i = 0; i < openings; ++i) {
        const auto cost = cost_once(preset, viewport);
        if (!cost) {
            fmt::print(stderr, "{}", to_string(cost.error()));
            return false;
        }
        costs.push_back(*cost);
    }
    const std::string name = preset.stem().string();
    bench::tell(topic, bench::ratio_figure(fmt::format("{}-{}", name, viewport.height),
                                           fmt::format("{}, {} x {}: CPU time relative to plain GL",
                                                       name, viewport.width, viewport.height),
                                           costs));
    return true;
}

int measure_costs(const std::vector<fs::path>& presets) {
    bool is_good = true;
    for (const Extent viewport : {Extent{640, 480}, Extent{1280, 720}})
        for (const fs::path& preset : presets)
            is_good = measure_cost(preset, viewport) && is_good;
    return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}

std::vector<fs::path> known_presets() {
    const char* corpus = std::getenv("AFTERGLOW_SLANG_DIR");
    if (!corpus) {
        fmt::print(
            "AFTERGLOW_SLANG_DIR isn't set. Set it to a copy of slang-shaders to run this "
            "bench.\n");
        return {};
    }
    std::vector<fs::path> presets;
    for (const char* preset :
         {"crt/crt-royale.slangp", "crt/crt-guest-advanced.slangp", "crt/crt-lottes.slangp",
          "crt/crt-geom.slangp", "edge-smoothing/xbr/xbr-lv2.slangp",
          "ntsc/ntsc-320px-composite.slangp", "ntsc/mame-ntsc.slangp",
          "blurs/dual_filter_bloom.slangp"})
        presets.push_back(fs::path(corpus) / preset);
    return presets;
}

int compare_pictures(const fs::path& preset) {
    constexpr int frames = 5;
    constexpr Extent viewport{640, 480};
    nlohmann::ordered_json output{{"file", preset.string()}};
    auto pair = plain::Pair::open(preset, original, viewport);
    const auto difference =
        pair ? pair->compare(frames) : Result<plain::Difference>(fail(pair.error()));
    if (difference) {
        output["mean"] = difference->mean;
        output["largest"] = difference->largest;
        output["reads_the_past"] = pair->reads_the_past();
    } else {
        output["why"] = to_string(difference.error());
    }
    fmt::print("{}\n", output.dump());
    return difference ? EXIT_SUCCESS : EXIT_FAILURE;
}

void compare_alone(const fs::path& preset) {
    constexpr double max_seconds = 600.0;
    constexpr std::size_t max_bytes = 1 << 20;
    auto child = ChildProcess::start({"/proc/self/exe", "pictures", preset.string()});
    const auto output = child ? child->read_all_within(max_seconds, max_bytes) : std::nullopt;
    const nlohmann::ordered_json lost{{"file", preset.string()}, {"why", "timed out"}};
    fmt::print("{}", output && !output->empty() ? *output : lost.dump() + "\n");
    std::fflush(stdout);
}
}  // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    if (words.empty())
        return measure_costs(known_presets());
    if (words[0] == "cost")
        return measure_costs({words.begin() + 1, words.end()});
    if (words.size() == 2 && words[0] == "pictures" && fs::is_regular_file(words[1]))
        return compare_pictures(words[1]);
    for (std::size_t i = 1; i < words.size(); ++i)
        for (const fs::path& preset : fs::is_directory(words[i])
                                          ? corpus_files(words[i], {".slangp", 0, 0})
                                          : std::vector<fs::path>{words[i]})
            compare_alone(preset);
    return EXIT_SUCCESS;
}
