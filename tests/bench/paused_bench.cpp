// Cost of an update of a paused lab: without changes, and while a parameter of the last pass or of
// the bloom changes. The reference is an executor that draws only these passes. A slow picture is
// drawn in slices. The number of slices depends on wall time, and so on the load of the machine.
#include "bench/bench_lab.h"
#include "bench/side_by_side.h"
#include "gpu/counted_draws.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

namespace {
namespace fs = std::filesystem;
using bench::wanted;

const bench::Topic topic{"paused", "Paused lab without a window, Phosphor at 1280 x 720"};

/// Phosphor in a lab without a window, paused after some frames.
class PausedLab : public bench::BenchLab {
public:
    PausedLab(const fs::path& folder, Extent extent) : BenchLab(folder, extent) {
        m_lab->looks().open("phosphor");
        while (m_lab->player().transport().frame_number() < 12)
            update();
        m_lab->player().pause();
        do
            update();
        while (m_lab->is_moving());
    }

    void update() { m_lab->update(1.0 / 60.0); }
    /// Updates until a picture drawn in slices is complete.
    void finish_picture() {
        m_is_sliced = false;
        for (update(); m_lab->frames().has_unfinished_frame(); update())
            m_is_sliced = true;
    }
    /// Whether the latest picture was drawn in slices.
    bool is_sliced() const { return m_is_sliced; }
    Extent extent() const { return m_lab->work().size.extent(); }
    void set(const std::string& name, double value) {
        m_lab->edit([&](Document& document) { document.set_value(name, Value(value)); });
    }
    const Executor& executor() const { return m_lab->renderer()->executor(); }
    const Values& values() const { return m_lab->document()->values(); }

private:
    bool m_is_sliced = false;
};

void tell_nothing(PausedLab& lab) {
    constexpr int updates = 2000;
    const CountedDraws draws;
    const double start = bench::busy_seconds();
    for (int i = 0; i < updates; ++i)
        lab.update();
    bench::tell(topic, {.key = "turn",
                        .what = "CPU time of one update without changes",
                        .value = 1e3 * (bench::busy_seconds() - start) / updates,
                        .unit = "ms",
                        .bound = bench::at_most(0.05)});
    bench::tell(topic, {.key = "draws",
                        .what = fmt::format("draw calls in {} updates without changes", updates),
                        .value = static_cast<double>(CountedDraws::take()),
                        .bound = bench::at_most(0.0)});
}

/// The same passes of the same frame, without a lab.
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
    int draw_calls() const { return m_executor.drawer().draw_calls(); }

private:
    Executor m_executor;
    std::vector<bool> m_draws;
    Values m_values;
    Frame m_frame;
};

void report_parameter(PausedLab& lab, const std::string& name, double from,
                      const std::vector<std::string>& passes) {
    constexpr double seconds = 20.0;
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
    bench::Figure figure = bench::ratio_figure(
        name, fmt::format("{} changed: CPU time relative to its passes alone", name),
        bench::side_by_side_for(seconds, plain, ours), bench::at_most(1.05));
    figure.detail +=
        lab.is_sliced()
            ? fmt::format("; {} draw calls in slices, reference {}", calls, alone.draw_calls())
            : fmt::format("; {} draw calls, reference {}", calls, alone.draw_calls());
    bench::tell(topic, figure);
}
}  // namespace

int main() {
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    {
        PausedLab lab(folder, {1280, 720});
        tell_nothing(lab);
        report_parameter(lab, "exposure", 1.5, {"composite"});
        report_parameter(lab, "bloom_radius", 3.0,
                         {"bloom_x", "bloom_down_1", "bloom_down_2", "bloom_down_3", "bloom_down_4",
                          "bloom_up_3", "bloom_up_2", "bloom_up_1", "bloom_y", "composite"});
    }
    fs::remove_all(folder);
    return EXIT_SUCCESS;
}
