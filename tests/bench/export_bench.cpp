// Writes a sequence into a file system in memory: 60 frames of Phosphor with the original article's
// formulas at 1280 x 720. EXR gets half floats, PNG bytes. Ideal is the CPU time of the same run,
// spread over all cores. A run is valid if the machine was idle in the second before.
// export_bench [RUNS [SECONDS TO WAIT FOR AN IDLE MACHINE]]
#include "bench/plain_png.h"
#include "bench/side_by_side.h"
#include "bench/wanted.h"
#include "io/pictures/png_encoder.h"
#include "lab/library/library.h"
#include "lab/offline/export.h"
#include "lab/offline/offline.h"
#include "model/picture/display_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace fs = std::filesystem;

namespace {
constexpr Extent size{1280, 720};
constexpr int frames = 60;
constexpr double quiet = 0.92;
constexpr double step_seconds = 4.0;
const bench::Topic topic{"export", "Export of 60 frames at 1280 x 720"};
using bench::wanted;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Idle share of all cores within one second.
double idle_share() {
    const auto read = [] {
        std::ifstream file("/proc/stat");
        std::string word;
        file >> word;
        std::array<double, 8> times{};
        for (double& time : times)
            file >> time;
        return times;
    };
    const auto before = read();
    std::this_thread::sleep_for(std::chrono::seconds(1));
    const auto after = read();
    double all = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i)
        all += after[i] - before[i];
    return (after[3] - before[3]) / all;
}

// Waits up to `max_seconds` for an idle machine.
double idle_before(int max_seconds) {
    double idle = idle_share();
    for (int i = 1; i < max_seconds && idle < quiet; ++i)
        idle = idle_share();
    return idle;
}

// Memory of this process in KiB: current ("VmRSS") or peak ("VmHWM").
double memory(const std::string& which) {
    std::ifstream file("/proc/self/status");
    std::string word;
    double kibibytes = 0.0;
    while (file >> word)
        if (word == which + ":" && file >> kibibytes)
            return kibibytes;
    return 0.0;
}

/// The Phosphor look with a picture in half floats, as EXR needs, or in bytes.
fs::path look_with(const std::string& texel, const fs::path& folder) {
    fs::path look = folder / texel;
    fs::copy(fs::path(AFTERGLOW_SOURCE_DIR) / "shaders/phosphor", look,
             fs::copy_options::recursive);
    fs::copy(fs::path(AFTERGLOW_SOURCE_DIR) / "shaders/include", folder / "include",
             fs::copy_options::recursive | fs::copy_options::skip_existing);
    std::ifstream file(look / "look.json");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string name = "\"composite\",";
    text.insert(text.find(name) + name.size(), " \"format\": \"" + texel + "\",");
    std::ofstream(look / "look.json") << text;
    return look;
}

Offline open_look(const fs::path& look, const fs::path& folder) {
    const Library library(
        Roots{AFTERGLOW_SOURCE_DIR, folder / "user", folder / "state", folder / "cache"});
    RenderRequest request;
    request.look = look.string();
    request.values = {{"as_written", "1"}};
    request.size = size;
    Offline offline = wanted(Offline::create(wanted(prepare(request, library)), size, 60.0));
    bench::tell_driver(offline.context().info());
    return offline;
}

int last_pass(const Offline& offline) {
    return static_cast<int>(offline.document().look().passes.size()) - 1;
}

struct Run {
    double idle = 0.0;
    double wall = 0.0;
    double cpu = 0.0;
    double more_memory = 0.0;  // KiB

    double ratio() const { return wall * std::thread::hardware_concurrency() / cpu; }
};

void write_one_by_one(Offline& offline, const ExportJob& job) {
    FramePipeline::Frame frame;
    for (frame.number = 0; frame.number < job.part.end; ++frame.number) {
        offline.advance();
        offline.read(job.pass, frame.picture);
        wanted(job.stages.deliver(frame.number, wanted(job.stages.make(frame))));
    }
}

Run run(Offline& offline, const FrameNames& names, bool is_piped, int timeout) {
    constexpr int warm_up = 5;
    wanted(offline.start_again(offline.document()));
    for (int i = 0; i < warm_up; ++i)
        offline.advance();
    const ExportJob job{.part = {0, frames},
                        .pass = last_pass(offline),
                        .stages = sequence_stages(names, 0),
                        .should_continue = [](std::int64_t) { return true; }};
    Run run;
    run.idle = idle_before(timeout);
    std::ofstream("/proc/self/clear_refs") << 5;  // resets the peak to the current value
    const double memory_before = memory("VmRSS");
    const double cpu = bench::busy_seconds();
    const auto start = Clock::now();
    if (is_piped)
        wanted(export_frames(offline, job));
    else
        write_one_by_one(offline, job);
    run.wall = seconds_since(start);
    run.cpu = bench::busy_seconds() - cpu;
    run.more_memory = memory("VmHWM") - memory_before;
    return run;
}

/// The runs on an idle machine; all runs if there are none.
std::vector<Run> counting(std::vector<Run> runs) {
    const auto is_busy = [](const Run& run) { return run.idle < quiet; };
    if (!std::ranges::all_of(runs, is_busy))
        std::erase_if(runs, is_busy);
    return runs;
}

void tell_runs(const std::string& key, const std::string& what, const std::vector<Run>& all,
               std::optional<bench::Bound> bound) {
    const std::vector<Run> runs = counting(all);
    const auto middle = [&runs](auto of) {
        std::vector<double> numbers;
        for (const Run& run : runs)
            numbers.push_back(of(run));
        return bench::median(std::move(numbers));
    };
    bench::tell(topic,
                {.key = key,
                 .what = fmt::format("{}: wall time relative to ideal", what),
                 .value = middle([](const Run& run) { return run.ratio(); }),
                 .bound = bound,
                 .idle = std::ranges::min(runs, {}, &Run::idle).idle,
                 .detail = fmt::format(
                     "{:.4g} ms per frame, {:.4g} ms of CPU time; {} of {} runs valid",
                     middle([](const Run& run) { return 1e3 * run.wall / frames; }),
                     middle([](const Run& run) { return 1e3 * run.cpu / frames; }),
                     std::ranges::count_if(all, [](const Run& run) { return run.idle >= quiet; }),
                     all.size())});
}

struct Measuring {
    int turns = 3;
    int timeout = 10;  // s
    fs::path folder = {};
};

struct Kind {
    std::string key;
    std::string texel;
    std::string ending;
    double frame_bytes;
    double maximum;  // limit of wall time relative to ideal
};

void measure_kind(const Kind& kind, const Measuring& measuring) {
    constexpr double max_frames = 6.0;
    const fs::path& folder = measuring.folder;
    Offline offline = open_look(look_with(kind.texel, folder), folder);
    const auto names = parse_frame_names((folder / ("f_%04d" + kind.ending)).string());
    run(offline, *names, true, 0);  // loads all code and tables
    tell_runs(kind.key + "-one-by-one",
              fmt::format("{} of {}, sequential", kind.ending, kind.texel),
              {run(offline, *names, false, measuring.timeout)}, {});
    std::vector<Run> runs;
    for (int turn = 0; turn < measuring.turns; ++turn)
        runs.push_back(run(offline, *names, true, measuring.timeout));
    tell_runs(kind.key, fmt::format("{} of {}, parallel encoders", kind.ending, kind.texel), runs,
              bench::at_most(kind.maximum));
    bench::tell(topic, {.key = kind.key + "-memory",
                        .what = fmt::format("{}: memory in addition to drawing", kind.ending),
                        .value = std::ranges::max(runs, {}, &Run::more_memory).more_memory *
                                 1024.0 / kind.frame_bytes,
                        .unit = "frames",
                        .bound = bench::at_most(max_frames)});
}

/// A picture of a look after some frames, as read back.
RawPicture read_picture_of(Offline& offline) {
    constexpr int settling = 30;
    for (int i = 0; i < settling; ++i)
        offline.advance();
    RawPicture raw;
    offline.read(last_pass(offline), raw);
    return raw;
}

void measure_reading(const fs::path& folder) {
    Offline offline = open_look(folder / "rgba16f", folder);
    RawPicture raw = read_picture_of(offline);
    const auto& halves = std::get<RawPicture::Halves>(raw.pixels);
    std::vector<std::uint16_t> copy(halves.size());
    const bench::Cost reading = bench::side_by_side_for(
        step_seconds, [&] { std::memcpy(copy.data(), halves.data(), 2 * halves.size()); },
        [&] { offline.read(last_pass(offline), raw); });
    bench::tell(topic, bench::ratio_figure(
                           "readback", "reading half floats: CPU time relative to a memory copy",
                           reading, bench::at_most(1.2)));
}

void measure_encoding(const fs::path& folder) {
    Offline offline = open_look(folder / "rgba8", folder);
    const RawPicture raw = read_picture_of(offline);
    const auto& rgba = std::get<RawPicture::Bytes>(raw.pixels);
    std::size_t plain_size = 0;
    std::size_t our_size = 0;
    bench::Figure figure = bench::ratio_figure(
        "png", "encoding a picture as PNG: CPU time relative to libpng",
        bench::side_by_side_for(
            step_seconds, [&] { plain_size = bench::plain_png(size, rgba).size(); },
            [&] { our_size = wanted(encode_png(size, display_bytes(raw))).size(); }),
        bench::at_most(1.1));
    figure.detail += fmt::format("; {} bytes, reference {} bytes", our_size, plain_size);
    bench::tell(topic, figure);
}
}  // namespace

int main(int argc, char** argv) {
    std::string name = "/dev/shm/afterglow-bench-XXXXXX";
    const char* folder = mkdtemp(name.data());
    if (!folder) {
        std::perror("export_bench: /dev/shm");
        return EXIT_FAILURE;
    }
    Measuring measuring{.folder = folder};
    if (argc > 1)
        measuring.turns = std::max(1, std::atoi(argv[1]));
    if (argc > 2)
        measuring.timeout = std::atoi(argv[2]);
    constexpr double texels = 1280.0 * 720.0;
    measure_kind({"exr-sequence", "rgba16f", ".exr", 8.0 * texels, 1.12}, measuring);
    measure_kind({"png-sequence", "rgba8", ".png", 4.0 * texels, 1.15}, measuring);
    measure_reading(measuring.folder);
    measure_encoding(measuring.folder);
    fs::remove_all(measuring.folder);
    return EXIT_SUCCESS;
}
