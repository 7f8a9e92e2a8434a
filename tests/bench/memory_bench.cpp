// Memory of Phosphor's targets and bytes that a frame moves, calculated from the plan with
// specialised programs, while no pass is inspected.
#include "bench/figure.h"
#include "bench/wanted.h"
#include "lab/offline/offline.h"

#include <fmt/format.h>

#include <cstdlib>

namespace {
constexpr Extent picture_extent{1920, 1080};
const bench::Topic topic{"memory", "Phosphor's memory at 1920 x 1080, calculated"};
using bench::wanted;

struct Setting {
    std::string key;
    std::string name;
    std::string preset;  // "": Default
    std::vector<std::pair<std::string, std::string>> values;
    std::optional<bench::Bound> megabytes;
    std::optional<bench::Bound> bytes;  // per pixel of the picture
};

Offline specialized(const Setting& setting) {
    RenderRequest request;
    request.look = "phosphor";
    request.preset = setting.preset;
    request.values = setting.values;
    request.size = picture_extent;
    const Library library(wanted(find_roots(AFTERGLOW_SOURCE_DIR)));
    Offline offline =
        wanted(Offline::create(wanted(prepare(request, library)), picture_extent, 60.0));
    wanted(offline.set_nan_policy(NanPolicy::off));
    wanted(offline.specialize());
    return offline;
}

void tell_memory(const Setting& setting) {
    const Offline offline = specialized(setting);
    bench::tell_driver(offline.context().info());
    const Executor& executor = offline.executor();
    bench::tell(topic, {.key = setting.key,
                        .what = fmt::format("{}: all targets", setting.name),
                        .value = 1e-6 * static_cast<double>(memory_of(executor.plan())),
                        .unit = "MB",
                        .bound = setting.megabytes});
    bench::tell(topic, {.key = setting.key + "-bytes",
                        .what = fmt::format("{}: written and read per pixel", setting.name),
                        .value = bytes_per_pixel(executor),
                        .unit = "bytes",
                        .bound = setting.bytes});
}
}  // namespace

int main() {
    constexpr bench::Bound max_32_bits = bench::at_most(115.0);
    constexpr bench::Bound max_16_bits = bench::at_most(80.0);
    const std::vector<Setting> settings{
        {"tube", "measured tube P31", "green-p31", {}, {}, {}},
        {"default", "Default", "", {}, max_32_bits, {}},
        {"article", "Original article", "article", {}, max_32_bits, {}},
        {"article-16",
         "Original article, 16 bit",
         "article",
         {{"light_bits", "1"}},
         max_16_bits,
         bench::at_most(48.0)},
        {"taps", "Original article, Blur Taps", "article", {{"bloom_kind", "Taps"}}, {}, {}},
        {"mono-32",
         "Original article, monochrome, 32 bit",
         "article-mono",
         {},
         max_32_bits,
         bench::at_most(26.0)},
        {"mono-16",
         "Original article, monochrome, 16 bit",
         "article-mono",
         {{"light_bits", "1"}},
         max_16_bits,
         bench::at_most(16.0)},
    };
    for (const Setting& setting : settings)
        tell_memory(setting);
    return EXIT_SUCCESS;
}
