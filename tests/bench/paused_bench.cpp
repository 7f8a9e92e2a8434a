// What a paused lab costs a turn: while nothing changes, and while a knob of the last pass or of
// the bloom is turned, beside an executor that draws these passes and nothing else. A picture that
// takes long is drawn in slices; how many bands that makes is a matter of wall time, so of who else
// works.
#include "bench/side_by_side.h"
#include "bench/wanted.h"
#include "gpu/counted_draws.h"
#include "lab/lab.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace {
namespace fs = std::filesystem;
using bench::wanted;

constexpr int rounds = 9;

/// Phosphor in a lab without a window, paused after some frames.
class PausedLab {
public:
    PausedLab(const fs::path& folder, Extent extent) : m_context(wanted(gpu::Context::headless())) {
        Roots roots{AFTERGLOW_SOURCE_DIR, folder / "user", folder / "state", folder / "cache"};
        m_lab = std::make_unique<Lab>(Library(std::move(roots)), *m_context,
                                      wanted(gpu::Context::shared_with(*m_context)));
        m_lab->set_picture_size({false, extent, 1.0});
        m_lab->open("phosphor");
        while (m_lab->player().frame_number() < 12)
            turn();
        m_lab->transport().pause();
        do
            turn();
        while (m_lab->is_moving());
    }

    void turn() { m_lab->update(1.0 / 60.0); }
    /// As many turns as a picture takes that is drawn in slices.
    void finish_picture() {
        m_is_sliced = false;
        for (turn(); m_lab->is_amid_frame(); turn())
            m_is_sliced = true;
    }
    /// The latest one was.
    bool is_sliced() const { return m_is_sliced; }
    Extent extent() const { return m_lab->picture_extent(); }
    void set(const std::string& name, double value) {
        m_lab->edit([&](Document& document) { document.set_value(name, Value(value)); });
    }
    const Executor& executor() const { return m_lab->renderer()->executor(); }
    const Values& values() const { return m_lab->document()->values(); }

private:
    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Lab> m_lab;
    bool m_is_sliced = false;
};

const char* verdict(bool counts, bool holds) {
    if (!counts)
        return "the machine is too busy";
    return holds ? "holds" : "DOES NOT HOLD";
}

void print_nothing(PausedLab& lab) {
    constexpr int turns = 2000;
    constexpr double most = 0.05;  // ms
    const CountedDraws draws;
    const double start = bench::busy_seconds();
    for (int i = 0; i < turns; ++i)
        lab.turn();
    const double each = 1e3 * (bench::busy_seconds() - start) / turns;
    const int count = CountedDraws::take();
    fmt::print("nothing changed: {:.4f} ms a turn, at most {}, {} draw calls in {} turns: {}\n",
               each, most, count, turns, verdict(true, each <= most && count == 0));
}

/// The same passes of the same frame, by nobody's asking.
class Alone {
public:
    Alone(const PausedLab& lab, const std::vector<std::string>& passes)
        : m_executor(lab.executor().look(), wanted(build_programs(lab.executor().look()))),
          m_draws(lab.executor().look().passes.size(), false) {
        wanted(m_executor.resize(lab.extent(), lab.extent()));
        for (const std::string& name : passes)
            m_draws[static_cast<std::size_t>(*find_pass(m_executor.look(), name))] = true;
        m_values = lab.values();
        m_frame.time = m_frame.time_delta = 1.0 / 60.0;
        m_frame.number = 1;
        m_frame.is_first = true;
        m_executor.draw(m_frame);
        m_frame.is_first = false;
    }
    void draw(const std::string& name, double value) {
        m_values.insert_or_assign(name, Value(value));
        m_executor.set_values(m_values);
        m_executor.redraw(m_frame, m_draws);
    }
    int draw_calls() const { return m_executor.draw_calls(); }

private:
    Executor m_executor;
    std::vector<bool> m_draws;
    Values m_values;
    Frame m_frame;
};

void print_knob(PausedLab& lab, const std::string& name, double from,
                const std::vector<std::string>& passes) {
    constexpr int frames = 4;
    constexpr double most = 1.05;
    Alone alone(lab, passes);
    int turned = 0;
    const auto next = [&] { return from * (1.0 + 0.01 * (++turned % 7)); };
    const auto ours = [&] {
        lab.set(name, next());
        lab.finish_picture();
    };
    const auto plain = [&] { alone.draw(name, next()); };
    plain();
    ours();
    int calls = 0;
    {
        const CountedDraws draws;
        ours();
        calls = CountedDraws::take();
    }
    const bench::Cost cost = bench::side_by_side(rounds, frames, plain, ours);
    fmt::print(
        "{} turned: {:.2f} ms, its passes alone {:.2f} ms: {:.3f} (itself {:.3f}); {} draw "
        "calls, its passes {}",
        name, cost.our_milliseconds, cost.plain_milliseconds, cost.ratio, cost.itself, calls,
        alone.draw_calls());
    fmt::print("{}; at most {}: {}\n", lab.is_sliced() ? ", in slices" : "", most,
               verdict(cost.counts(), cost.ratio <= most));
    std::fflush(stdout);
}
}  // namespace

int main() {
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    {
        constexpr Extent extent{1280, 720};
        PausedLab lab(folder, extent);
        fmt::print("Phosphor at {} x {}, paused\n", extent.width, extent.height);
        print_nothing(lab);
        print_knob(lab, "exposure", 1.5, {"composite"});
        print_knob(lab, "bloom_radius", 3.0,
                   {"bloom_x", "bloom_down_1", "bloom_down_2", "bloom_down_3", "bloom_down_4",
                    "bloom_up_3", "bloom_up_2", "bloom_up_1", "bloom_y", "composite"});
    }
    fs::remove_all(folder);
    return EXIT_SUCCESS;
}
