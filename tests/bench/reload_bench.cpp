// Hot reload of a composite at 1280 x 720, the article's and Phosphor's. Twenty texts that no cache
// has are saved in place and by rename while values are static, and by rename while they change.
// Then texts from before are saved. The reference is a plain GL program that does the minimum:
// parse with glslang, compile and link with GL, draw once.
//
// The driver draws on the calling thread (LP_NUM_THREADS=0), so the drawing thread's CPU time is
// the cost of a frame. Waiting is measured as wall time, everything else as CPU time, which does
// not depend on the load of the machine.
#include "bench/plain_reload.h"
#include "bench/reload_looks.h"
#include "bench/side_by_side.h"
#include "gpu/headless_context.h"
#include "io/files/atomic_file.h"
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
using bench::busy_seconds;

constexpr int edits = 20;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double thread_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(
        std::lround(share * static_cast<double>(values.size() - 1)))];
}

void tell(const bench::Topic& topic, const std::string& key, const std::string& what,
          const std::vector<double>& milliseconds, std::optional<bench::Bound> bound = {}) {
    bench::tell(topic, {.key = key,
                        .what = what,
                        .value = quantile(milliseconds, 0.5),
                        .unit = "ms",
                        .bound = bound,
                        .detail = fmt::format("p95 {:.3g}", quantile(milliseconds, 0.95))});
}

struct Folders {
    Folders(const fs::path& all, const bench::ReloadLook& reloaded)
        : look(reloaded),
          file(all / "shaders" / reloaded.folder / "composite.frag"),
          text(bench::text_of(file)) {}
    std::string edited(int number) const { return bench::with_factor(text, look, number); }
    void save(const std::string& saved, bool by_rename) const {
        if (by_rename)
            static_cast<void>(write_atomically(file, saved));
        else
            std::ofstream(file) << saved;
    }

    const bench::ReloadLook& look;
    fs::path file;
    std::string text;
};

/// A lab with that look, without a window.
class ReloadBench {
public:
    ReloadBench(const fs::path& folder, const Folders& folders) : m_folders(folders) {
        auto context = gpu::create_headless_context();
        auto worker = context ? gpu::Context::shared_with(**context) : fail(context.error());
        if (!worker) {
            fmt::print(stderr, "{}", to_string(worker.error()));
            std::exit(EXIT_FAILURE);
        }
        m_context = std::move(*context);
        bench::tell_driver(m_context->info());
        m_lab = std::make_unique<Lab>(
            Library({folder, folder / "user", folder / "state", folder / "cache"}), *m_context,
            std::move(*worker));
        m_lab->work().size.choose({false, {1280, 720}, 1.0});
        m_lab->looks().open(m_folders.look.folder);
        while (m_lab->player().transport().frame_number() < 10)
            frame();
        for (const auto start = Clock::now(); milliseconds_since(start) < 2500.0;)
            frame();  // finishes the work after the first picture
    }
    ~ReloadBench() { m_lab.reset(); }
    ReloadBench(const ReloadBench&) = delete;
    ReloadBench& operator=(const ReloadBench&) = delete;

    const Lab& lab() const { return *m_lab; }

    /// Makes values static from now on, or changes one of them.
    void rest(bool rests) {
        if (!rests)
            m_lab->edit([this](Document& document) {
                document.set_value(m_folders.look.turned, Value(m_turned += 0.001));
                document.finish();
            });
        frame();
        while (rests && !m_lab->renderer()->executor().programs().is_specialized())
            frame(0.1);
    }

    /// CPU time of the process.
    double steady_milliseconds() {
        const double start = busy_seconds();
        frame();
        return 1e3 * (busy_seconds() - start);
    }

    /// CPU time of the process from the save to the first new frame, minus one such frame. No time
    /// passes and no frame is drawn while the text is loaded.
    double over_a_frame(const std::string& text, bool by_rename) {
        m_folders.save(text, by_rename);
        const double start = busy_seconds();
        while (!shows(text)) {
            m_lab->update(0.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(8));
        }
        frame();
        const double all = 1e3 * (busy_seconds() - start);
        return all -
               bench::median({steady_milliseconds(), steady_milliseconds(), steady_milliseconds()});
    }

    /// The longest frame on the drawing thread, compared with the same time without an edit.
    struct Gap {
        double with_edit = 0.0;  // until the text is displayed, plus five frames
        double without = 0.0;    // over the same number of frames without an edit
    };
    Gap longest_gap(const std::string& text, bool by_rename) {
        std::vector<double> edited;
        m_folders.save(text, by_rename);
        while (!shows(text))
            edited.push_back(frame_on_thread());
        for (int i = 0; i < 5; ++i)
            edited.push_back(frame_on_thread());
        std::vector<double> plain;
        for (std::size_t i = 0; i < edited.size(); ++i)
            plain.push_back(frame_on_thread());
        const double steady = bench::median(plain);
        return {std::ranges::max(edited) - steady, std::ranges::max(plain) - steady};
    }

private:
    bool shows(const std::string& text) const {
        const std::string& drawn = m_lab->renderer()->executor().look().passes.back().fragment.text;
        return !m_lab->loader().is_loading() &&
               drawn.find(bench::edited_line(text, m_folders.look)) != std::string::npos;
    }
    void frame(double seconds = 1.0 / 60.0) {
        m_lab->update(seconds);
        while (m_lab->frames().has_unfinished_frame())
            m_lab->update(0.0);
        gpu::finish();
    }
    double frame_on_thread() {
        const double start = thread_milliseconds();
        frame();
        return thread_milliseconds() - start;
    }

    const Folders& m_folders;
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Lab> m_lab;
    double m_turned = 1.5;
};

/// Only the look loader: the time from a save until it is linked, before any draw.
class LinkBench {
public:
    LinkBench(const fs::path& folder, const Folders& folders)
        : m_folders(folders), m_context(gpu::create_headless_context().value()) {
        const Roots roots{folder, folder / "user", folder / "state", folder / "cache"};
        m_loader = std::make_unique<LookLoader>(gpu::Context::shared_with(*m_context).value(),
                                                *m_context, roots, m_messages);
        m_loader->open({folders.file.parent_path(), {}, {}});
        take();
        m_loader->note_update(true);
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    }
    ~LinkBench() { m_loader.reset(); }
    LinkBench(const LinkBench&) = delete;
    LinkBench& operator=(const LinkBench&) = delete;

    double saved_to_linked(const std::string& text, bool by_rename) {
        m_folders.save(text, by_rename);
        const auto start = Clock::now();
        double linked = 0.0;
        while (linked == 0.0) {
            m_loader->take_changed_files();
            const PassProgress::State state = m_loader->worker().queue().progress();
            if (m_loader->is_reading() && state.step == PassProgress::Step::drawing)
                linked = milliseconds_since(start);
            else
                std::this_thread::sleep_for(std::chrono::microseconds(50));
        }
        take();
        return linked;
    }

private:
    void take() {
        std::optional<BuiltLook> built;
        while (!(built = m_loader->update({.picture = {1280, 720}}, 0.0)))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        m_loader->programs().set(std::move(*built->programs));
    }

    const Folders& m_folders;
    std::unique_ptr<gpu::Context> m_context;
    Messages m_messages;
    std::unique_ptr<LookLoader> m_loader;
};

// Returns the median, in milliseconds.
double measure_links(const bench::Topic& topic, const fs::path& folder, const Folders& folders,
                     int first_text) {
    LinkBench links(folder, folders);
    std::vector<double> linked;
    for (int i = 0; i < edits; ++i)
        linked.push_back(links.saved_to_linked(folders.edited(first_text + i), i % 2 == 1));
    tell(topic, "linked", "save to linked programs: wall time", linked);
    folders.save(folders.text, false);
    const std::vector<double> later(linked.begin() + 1, linked.end());
    bench::tell(topic, {.key = "first",
                        .what = "save to linked programs: first edit relative to later edits",
                        .value = linked.front() / bench::median(later),
                        .bound = bench::at_most(1.3)});
    return bench::median(linked);
}

/// How edits are saved, and whether values change at the same time.
struct Way {
    const char* key;
    const char* name;
    bool by_rename;
    bool rests;
};

void measure_way(const bench::Topic& topic, const Way& way, ReloadBench& reloads,
                 bench::PlainReload& plain, const Folders& folders, int& number) {
    const std::string key = std::string(way.key) + "-";
    const std::string how = way.name;
    std::vector<double> ours;
    std::vector<double> raw;
    std::vector<double> ratios;
    std::vector<double> longest;
    std::vector<double> added;
    std::vector<double> seen;
    for (int i = 0; i < edits; ++i) {
        reloads.rest(way.rests);
        raw.push_back(plain.over_a_frame(number++));
        ours.push_back(reloads.over_a_frame(folders.edited(number++), way.by_rename));
        ratios.push_back(ours.back() / raw.back());
    }
    for (int i = 0; i < edits; ++i) {
        reloads.rest(way.rests);
        const auto gap = reloads.longest_gap(folders.edited(number++), way.by_rename);
        longest.push_back(gap.with_edit);
        added.push_back(gap.with_edit - gap.without);
    }
    for (int i = 0; i < edits; ++i) {
        reloads.rest(way.rests);
        seen.push_back(reloads.over_a_frame(folders.edited(number - 1 - i % 5), way.by_rename));
    }
    seen.erase(seen.begin());
    tell(topic, key + "plain",
         fmt::format("{}: plain GL program, CPU time above a steady frame", how), raw);
    tell(topic, key + "frame",
         fmt::format("{}: save to first new frame, CPU time above a steady frame", how), ours);
    bench::tell(topic, {.key = key + "ratio",
                        .what = fmt::format(
                            "{}: save to first new frame, relative to the plain GL program", how),
                        .value = bench::median(ratios),
                        .bound = bench::at_most(1.10)});
    tell(topic, key + "longest",
         fmt::format("{}: longest frame during reload minus steady frame, CPU time", how), longest);
    tell(topic, key + "added",
         fmt::format("{}: longest frame during reload minus longest frame without reload", how),
         added, bench::at_most(5.0));
    tell(topic, key + "seen",
         fmt::format("{}: return to an earlier text, CPU time above a steady frame", how), seen,
         bench::at_most(15.0));
}

void measure_frames(const bench::Topic& topic, const fs::path& folder, const Folders& folders,
                    int first_text, double linked_milliseconds) {
    ReloadBench reloads(folder, folders);
    bench::PlainReload plain(reloads.lab().renderer()->executor(), folders.look);
    std::vector<double> linked;
    for (int i = 0; i < edits; ++i)
        linked.push_back(plain.until_linked(first_text++));
    tell(topic, "plain-linked", "plain GL program: wall time to parse and link", linked);
    bench::tell(topic, {.key = "linked-added",
                        .what = "save to linked programs minus plain GL program: wall time",
                        .value = linked_milliseconds - bench::median(linked),
                        .unit = "ms",
                        .bound = bench::at_most(15.0)});
    for (const Way& way : {Way{"place", "static values, in-place save", false, true},
                           Way{"rename", "static values, rename", true, true},
                           Way{"turned", "changing values, rename", true, false}})
        measure_way(topic, way, reloads, plain, folders, first_text);
}
}  // namespace

/// reload_bench [KEY]: all looks, or one.
int main(int count, char** arguments) {
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    // A shader cache from an earlier run would replace the compiler.
    setenv("MESA_SHADER_CACHE_DIR", (folder / "driver").c_str(), 1);
    setenv("LP_NUM_THREADS", "0", 1);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    bench::write_reload_looks(folder / "shaders");
    for (const bench::ReloadLook& look : bench::reload_looks()) {
        if (count > 1 && std::string_view(arguments[1]) != look.key)
            continue;
        const bench::Topic topic{look.key,
                                 fmt::format("Hot reload of {}, {} edits", look.name, edits)};
        const Folders folders(folder, look);
        const double linked = measure_links(topic, folder, folders, 1000);
        measure_frames(topic, folder, folders, 2000, linked);
    }
    fs::remove_all(folder);
    return EXIT_SUCCESS;
}
