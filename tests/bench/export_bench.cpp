// Writing a sequence: 60 frames of the Phosphor look, as the article has it, at 1280 x 720, its
// picture in half floats for EXR and in bytes for PNG, into a file system in memory. Ideal is all
// CPU time of the same run spread over all cores. One after the other and by the pipeline take
// turns; a run counts where the machine was idle in the second before. export_bench [TURNS [SECONDS
// TO WAIT FOR QUIET]]
#include "gpu/readback.h"
#include "io/png_encoder.h"
#include "lab/export.h"
#include "lab/library.h"
#include "lab/offline.h"
#include "model/display_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sys/resource.h>
#include <thread>

namespace fs = std::filesystem;

namespace {
constexpr Extent size{1280, 720};
constexpr int frames = 60;
constexpr double quiet = 0.92;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Of the cores' time within a second, how much nobody wants.
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

// Waits a while for a quiet machine.
double idle_before(int most_seconds) {
    double idle = idle_share();
    for (int i = 1; i < most_seconds && idle < quiet; ++i)
        idle = idle_share();
    return idle;
}

// KiB of this program in memory, now ("VmRSS") or at most ("VmHWM").
double memory(const std::string& which) {
    std::ifstream file("/proc/self/status");
    std::string word;
    double kibibytes = 0.0;
    while (file >> word)
        if (word == which + ":" && file >> kibibytes)
            return kibibytes;
    return 0.0;
}

void or_end(const auto& result) {
    if (result)
        return;
    fmt::print(stderr, "{}", to_string(result.error()));
    std::exit(EXIT_FAILURE);
}

/// The Phosphor look whose picture has half floats, as EXR wants them, or bytes.
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
    auto prepared = prepare(request, library);
    or_end(prepared);
    auto offline = Offline::create(std::move(*prepared), size, 60.0);
    or_end(offline);
    return std::move(*offline);
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
        auto made = job.stages.make(frame);
        or_end(made);
        or_end(job.stages.deliver(frame.number, std::move(*made)));
    }
}

Run run(Offline& offline, const FrameNames& names, bool is_piped, int patience) {
    constexpr int warm_up = 5;
    or_end(offline.start_again(offline.document()));
    for (int i = 0; i < warm_up; ++i)
        offline.advance();
    const ExportJob job{.part = {0, frames},
                        .pass = static_cast<int>(offline.document().look().passes.size()) - 1,
                        .stages = sequence_stages(names, 0),
                        .go_on = [](std::int64_t) { return true; }};
    Run run;
    run.idle = idle_before(patience);
    std::ofstream("/proc/self/clear_refs") << 5;  // the most so far is what it has now
    const double memory_before = memory("VmRSS");
    const double cpu = cpu_seconds();
    const auto start = Clock::now();
    if (is_piped)
        or_end(export_frames(offline, job));
    else
        write_one_by_one(offline, job);
    run.wall = seconds_since(start);
    run.cpu = cpu_seconds() - cpu;
    run.more_memory = memory("VmHWM") - memory_before;
    return run;
}

void print(const char* how, const Run& run, double frame_kibibytes) {
    fmt::print(
        "  {:<14} {:6.1f} ms a frame, {:6.1f} cpu-ms: {:.3f} of ideal; {:4.1f} frames of memory; "
        "idle "
        "before {:3.0f} %{}\n",
        how, 1000.0 * run.wall / frames, 1000.0 * run.cpu / frames, run.ratio(),
        run.more_memory / frame_kibibytes, 100.0 * run.idle,
        run.idle < quiet ? ": not quiet, does not count" : "");
}

struct Measuring {
    int turns = 3;
    int patience = 20;  // s
    fs::path folder = {};
};

void compare_ways(const std::string& texel, const std::string& ending, double frame_bytes,
                  const Measuring& measuring) {
    const fs::path& folder = measuring.folder;
    Offline offline = open_look(look_with(texel, folder), folder);
    const auto names = parse_frame_names((folder / ("f_%04d" + ending)).string());
    run(offline, *names, true, 0);  // all code and tables are there
    fmt::print("{} of {}:\n", ending, texel);
    for (int turn = 0; turn < measuring.turns; ++turn) {
        print("one by one", run(offline, *names, false, measuring.patience), frame_bytes / 1024.0);
        print("by pipeline", run(offline, *names, true, measuring.patience), frame_bytes / 1024.0);
    }
}

// The least of several, in milliseconds of this thread's work.
double least_milliseconds(const auto& work) {
    double least = 1e9;
    for (int i = 0; i < 40; ++i) {
        timespec before{};
        timespec after{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
        work();
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
        least = std::min(least, 1e3 * static_cast<double>(after.tv_sec - before.tv_sec) +
                                    1e-6 * static_cast<double>(after.tv_nsec - before.tv_nsec));
    }
    return least;
}

void time_steps(const fs::path& folder) {
    Offline offline = open_look(folder / "rgba16f", folder);
    const int pass = static_cast<int>(offline.document().look().passes.size()) - 1;
    for (int i = 0; i < 30; ++i)
        offline.advance();
    RawPicture raw;
    offline.read(pass, raw);
    const auto& halves = std::get<RawPicture::Halves>(raw.pixels);
    std::vector<std::uint16_t> copy(halves.size());
    const double copying =
        least_milliseconds([&] { std::memcpy(copy.data(), halves.data(), 2 * halves.size()); });
    const double reading = least_milliseconds([&] { offline.read(pass, raw); });
    const std::vector<std::uint8_t> rgb = display_bytes(raw);
    fmt::print(
        "Steps: reading half floats {:.2f} ms, {:.2f} of a copy; display bytes {:.1f} ms, PNG of "
        "them {:.1f} ms\n",
        reading, reading / copying, least_milliseconds([&] { (void)display_bytes(raw); }),
        least_milliseconds([&] { (void)encode_png(size, rgb); }));
}
}  // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
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
        measuring.patience = std::atoi(argv[2]);
    constexpr double texels = 1280.0 * 720.0;
    compare_ways("rgba16f", ".exr", 8.0 * texels, measuring);
    compare_ways("rgba8", ".png", 4.0 * texels, measuring);
    time_steps(measuring.folder);
    fs::remove_all(measuring.folder);
    return EXIT_SUCCESS;
}
