// Opens heavy libretro presets while a light look is shown. Measures the time until each is open,
// with empty caches and again, and the longest updates of the drawing thread until then. For that
// long, the window would stop responding. Needs AFTERGLOW_SLANG_DIR.
#include "bench/bench_lab.h"
#include "gpu/objects/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <thread>

namespace fs = std::filesystem;

namespace {
const bench::Topic topic{"opening",
                         "Opening libretro presets at 640 x 480 while another look is shown"};

double busy_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Update {
    double milliseconds;
    std::string doing;
};

struct Attempt {
    const char* key;
    const char* name;
};

/// A lab of 640 x 480 px without a window and with its own folder.
class OpeningBench : public bench::BenchLab {
public:
    explicit OpeningBench(const fs::path& folder) : BenchLab(folder, {640, 480}) {
        m_lab->looks().open("crt");
        while (m_lab->player().transport().frame_number() < 10)
            update();
    }

    /// Returns false if the preset does not open.
    bool open(const fs::path& preset, const Attempt& attempt) {
        const auto start = std::chrono::steady_clock::now();
        std::vector<Update> updates;
        m_lab->looks().open(preset.string());
        while (m_lab->loader().is_loading())
            updates.push_back(update());
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        if (m_lab->document()->look().manifest != preset)
            return false;
        std::vector<Update> later;
        while (m_lab->player().transport().frame_number() < 4)
            later.push_back(update());
        const double longest = std::ranges::max(later, {}, &Update::milliseconds).milliseconds;
        std::ranges::sort(updates, std::ranges::greater(), &Update::milliseconds);
        const auto tell = [&](const std::string& key, const std::string& what, double value,
                              const char* unit, const std::string& detail = {}) {
            bench::tell(topic, {.key = preset.stem().string() + "-" + attempt.key + "-" + key,
                                .what = fmt::format("{}, {}: {}", preset.stem().string(),
                                                    attempt.name, what),
                                .value = value,
                                .unit = unit,
                                .detail = detail});
        };
        tell("open", "time to open", seconds.count(), "s");
        tell("turn", "longest update until then, CPU time", updates.front().milliseconds, "ms",
             updates.front().doing);
        tell("later", "longest update of the first three frames, CPU time", longest, "ms",
             fmt::format("of {} updates", later.size()));
        return true;
    }

private:
    Update update() {
        const double start = busy_milliseconds();
        m_lab->update(1.0 / 60.0);
        gpu::finish();
        Update update{busy_milliseconds() - start, "start"};
        if (const auto opening = m_lab->loader().opening())
            update.doing = to_string(opening->progress);
        if (!m_lab->loader().is_loading())
            update.doing = "switch";
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        return update;
    }
};
}  // namespace

int main() {
    const char* corpus = std::getenv("AFTERGLOW_SLANG_DIR");
    if (!corpus) {
        fmt::print(
            "AFTERGLOW_SLANG_DIR isn't set. Set it to a copy of slang-shaders to run this "
            "bench.\n");
        return EXIT_SUCCESS;
    }
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    // The driver opens its cache once per process.
    setenv("MESA_SHADER_CACHE_DIR", (folder / "driver").c_str(), 1);
    bool is_open = true;
    for (const char* preset : {"crt/crt-royale.slangp", "crt/crt-guest-advanced.slangp",
                               "bezel/Mega_Bezel/Presets/MBZ__3__STD.slangp"})
        for (const Attempt& attempt : {Attempt{"new", "first time"}, Attempt{"kept", "again"}})
            is_open = is_open && OpeningBench(folder).open(fs::path(corpus) / preset, attempt);
    fs::remove_all(folder);
    return is_open ? EXIT_SUCCESS : EXIT_FAILURE;
}
