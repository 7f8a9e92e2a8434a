// Hot reload of Phosphor's composite: from the save to the program that is linked and made ready to
// draw, to the first frame drawn with it, and that frame alone, against a steady frame of the same
// run: the picture must not stop for an edit. Twenty texts never seen before, saved in
// place and by rename.
#include "gpu/draw.h"
#include "io/atomic_file.h"
#include "lab/lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace fs = std::filesystem;

namespace {
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(
        std::lround(share * static_cast<double>(values.size() - 1)))];
}

void print(const char* what, const std::vector<double>& milliseconds) {
    fmt::print("{:<34} median {:7.2f} ms   p95 {:7.2f} ms\n", what, quantile(milliseconds, 0.5),
               quantile(milliseconds, 0.95));
}

/// A copy of Phosphor in a folder of its own, open in a lab of 1280 x 720 px without a window.
class Bench {
public:
    Bench() {
        std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
        m_folder = mkdtemp(name.data());
        fs::copy(fs::path(AFTERGLOW_SOURCE_DIR) / "shaders", m_folder / "shaders",
                 fs::copy_options::recursive);
        m_file = m_folder / "shaders" / "phosphor" / "composite.frag";
        std::ifstream stream(m_file);
        m_text.assign(std::istreambuf_iterator<char>(stream), {});
        // A cache of shaders from an earlier run would answer for the compiler.
        setenv("MESA_SHADER_CACHE_DIR", (m_folder / "cache").c_str(), 1);
        auto context = gpu::Context::headless();
        auto worker = context ? gpu::Context::shared_with(**context) : fail(context.error());
        if (!worker) {
            fmt::print(stderr, "{}", to_string(worker.error()));
            std::exit(EXIT_FAILURE);
        }
        m_context = std::move(*context);
        m_lab = std::make_unique<Lab>(Library({m_folder, m_folder / "user", m_folder / "state"}),
                                      *m_context, std::move(*worker));
        m_lab->set_picture_size({false, {1280, 720}, 1.0});
        m_lab->open("phosphor");
        while (m_lab->player().frame_number() < 10)
            turn();
    }
    ~Bench() {
        m_lab.reset();
        m_context.reset();
        fs::remove_all(m_folder);
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    const gpu::Facts& facts() const { return m_context->facts(); }

    double steady_frame() {
        const auto start = Clock::now();
        turn();
        return milliseconds_since(start);
    }

    struct Times {
        double linked = 0.0;
        double shown = 0.0;
        double frame = 0.0;  // the first new one alone
    };
    Times edit(bool by_rename) {
        // A factor that no text had before, and that changes nothing one could see.
        const std::string text =
            m_text + fmt::format("// {0}\nfloat unused_{0}() {{ return {0}.0; }}\n", ++m_edits);
        const auto start = Clock::now();
        if (by_rename)
            (void)write_atomically(m_file, text);
        else
            std::ofstream(m_file) << text;
        Times times;
        const auto is_new = [&] {
            return m_lab->renderer()->executor().look().passes.back().fragment.text.find(
                       fmt::format("unused_{}(", m_edits)) != std::string::npos;
        };
        // Only the reload is looked at until it is there; then one frame is drawn.
        m_lab->transport().pause();
        while (!is_new()) {
            m_lab->update(0.0);
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
        times.linked = milliseconds_since(start);
        m_lab->transport().play();
        turn();
        times.shown = milliseconds_since(start);
        times.frame = times.shown - times.linked;
        m_lab->update(1.0 / 60.0);
        return times;
    }

private:
    void turn() {
        m_lab->update(1.0 / 60.0);
        gpu::finish();
    }

    fs::path m_folder;
    fs::path m_file;
    std::string m_text;
    int m_edits = 0;
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Lab> m_lab;
};

void measure(Bench& bench, const char* how, bool by_rename) {
    constexpr int edits = 20;
    std::vector<double> linked;
    std::vector<double> shown;
    std::vector<double> first;
    std::vector<double> steady;
    for (int i = 0; i < edits; ++i) {
        const Bench::Times times = bench.edit(by_rename);
        linked.push_back(times.linked);
        shown.push_back(times.shown);
        first.push_back(times.frame);
        for (int frame = 0; frame < 3; ++frame)
            steady.push_back(bench.steady_frame());
    }
    fmt::print("{}\n", how);
    print("  saved to linked and warm", linked);
    print("  saved to the first new frame", shown);
    print("  the first new frame alone", first);
    print("  steady frame", steady);
    fmt::print("  first new frame / steady frame: {:.2f}\n",
               quantile(first, 0.5) / quantile(steady, 0.5));
}
}  // namespace

int main() {
    Bench bench;
    fmt::print("Hot reload, Phosphor at 1280 x 720, {}\n", bench.facts().renderer);
    measure(bench, "saved in place (close-write)", false);
    measure(bench, "saved by rename", true);
    return EXIT_SUCCESS;
}
