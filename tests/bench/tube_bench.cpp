// Cost of the looks that model a tube's time, light and signal, compared with the look crt at the
// same size. All programs are specialised.
#include "bench/side_by_side.h"
#include "bench/wanted.h"
#include "lab/offline/offline.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {
const bench::Topic topic{"tube", "Time, light and signal of a tube, relative to crt"};

using Settings = std::vector<std::pair<std::string, std::string>>;

Offline opened(const std::string& look, const Settings& values, Extent extent, bool has_subframes) {
    RenderRequest request;
    request.look = look;
    request.values = values;
    request.source = "pattern:harbour";
    request.size = extent;
    request.draws_subframes = has_subframes;
    const Library library(bench::wanted(find_roots(AFTERGLOW_SOURCE_DIR)));
    Offline offline =
        bench::wanted(Offline::create(bench::wanted(prepare(request, library)), extent, 60.0));
    if (auto off = offline.set_nan_policy(NanPolicy::off); !off)
        bench::give_up(off.error());
    if (auto specialized = offline.specialize(); !specialized)
        bench::give_up(specialized.error());
    return offline;
}

struct Row {
    const char* key;
    const char* what;
    std::string look;
    Settings values = {};
    std::optional<bench::Bound> bound = std::nullopt;
    bool has_subframes = false;
};

void measure(const Row& row, const char* size, Extent extent) {
    constexpr double seconds = 8.0;
    Offline crt = opened("crt", {}, extent, false);
    Offline ours = opened(row.look, row.values, extent, row.has_subframes);
    const auto draw = [](Offline& offline) {
        return [&offline] {
            offline.make_current();
            offline.advance();
        };
    };
    const bench::Cost cost = bench::side_by_side_for(seconds, draw(crt), draw(ours));
    bench::tell(topic, bench::ratio_figure(fmt::format("{}-{}", row.key, size),
                                           fmt::format("{}, {} lines high: CPU time / crt",
                                                       row.what, extent.height),
                                           cost, row.bound));
}
}  // namespace

int main() {
    const bench::Bound bound = bench::at_most(3.0);
    const std::vector<Row> rows{
        {"raster-240", "raster-beam with 240 lines", "raster-beam", {{"raster_lines", "1"}}, bound},
        {"raster-480", "raster-beam with 480 lines", "raster-beam", {{"raster_lines", "3"}}, bound},
        {"composite", "composite-video", "composite-video"},
        {"rolling", "crt+rolling-scan, per sub-frame", "crt+rolling-scan", {}, {}, true},
    };
    for (const Row& row : rows) {
        measure(row, "1080p", {1920, 1080});
        measure(row, "2160p", {3840, 2160});
    }
    return EXIT_SUCCESS;
}
