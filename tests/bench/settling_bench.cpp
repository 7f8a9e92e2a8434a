// Cost of a frame of the window's picture with specialised programs (static values as constants).
// It is compared with the generic programs that draw while a value changes. CPU time of the
// process. The reference is measured twice; if the two differ, the run is noise.
#include "bench/bench_lab.h"
#include "bench/side_by_side.h"
#include "model/tuning/modulation.h"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>

namespace fs = std::filesystem;

namespace {
const bench::Topic topic{"settling",
                         "Specialised programs: a frame with static values at 1280 x 720"};

class SettlingBench : public bench::BenchLab {
public:
    explicit SettlingBench(const fs::path& folder) : BenchLab(folder, {1280, 720}) {}

    void open(const std::string& look) {
        m_lab->looks().open(look);
        m_lab->update(0.0);
        while (m_lab->loader().is_loading() || !m_lab->renderer() ||
               m_lab->player().transport().frame_number() < 5)
            frame();
    }
    double frame_milliseconds() {
        constexpr int frames = 4;
        const double start = bench::busy_seconds();
        for (int i = 0; i < frames; ++i)
            frame();
        return 1e3 * (bench::busy_seconds() - start) / frames;
    }
    /// Returns false if the driver rejects specialised programs.
    bool specialize() {
        constexpr double longest = 0.1;  // of one update, so that the loop needs no waiting
        constexpr int max_frames = 300;
        int frames = 0;
        while (!m_lab->renderer()->executor().programs().is_specialized() && ++frames < max_frames)
            frame(longest);
        frame();
        frame();
        return frames < max_frames;
    }
    /// The first change of a drag; too small to be visible.
    void change_a_parameter() {
        const Look& look = m_lab->document()->look();
        const auto changed = std::ranges::find_if(look.parameters, [&](const Parameter& parameter) {
            return why_unmodulated(look, parameter).empty();
        });
        m_lab->edit([&](Document& document) {
            const double value = document.value(*changed).number();
            document.set_value(changed->name, Value(value + (value > 0.5 ? -1e-5 : 1e-5)));
            document.finish();
        });
        frame();
    }
    double first_update_milliseconds() {
        const double start = bench::busy_seconds();
        change_a_parameter();
        return 1e3 * (bench::busy_seconds() - start);
    }

private:
    void frame(double seconds = 1.0 / 60.0) {
        m_lab->update(seconds);
        while (m_lab->frames().has_unfinished_frame())
            m_lab->update(0.0);
        gpu::finish();
    }
};

void measure(SettlingBench& bench, const std::string& look) {
    constexpr int rounds = 5;
    const std::string name = fs::path(look).stem().string();
    bench.open(look);
    std::vector<double> own;
    std::vector<double> ratios;
    std::vector<double> itself;
    std::vector<double> updates;
    for (int i = 0; i < rounds; ++i) {
        if (!bench.specialize()) {
            fmt::print("  {}: no specialised programs, so not measured\n", look);
            return;
        }
        const double specialized = bench.frame_milliseconds();
        updates.push_back(bench.first_update_milliseconds());
        const double one = bench.frame_milliseconds();
        const double other = bench.frame_milliseconds();
        own.push_back((one + other) / 2.0);
        ratios.push_back(specialized / own.back());
        itself.push_back(one / other);
    }
    bench::tell(topic, {.key = name,
                        .what = fmt::format("{}: CPU time relative to generic programs", name),
                        .value = bench::median(ratios),
                        .itself = bench::median(itself),
                        .detail = fmt::format("generic {:.4g} ms, first frame after a change "
                                              "{:.4g} ms",
                                              bench::median(own), bench::median(updates))});
}
}  // namespace

int main(int argc, char** argv) {
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    std::vector<std::string> looks(argv + 1, argv + argc);
    if (looks.empty())
        looks = {"phosphor",    "presets/phosphor/crisp-lab-scope.json",
                 "crt",         "shadow-mask",
                 "vector-beam", "caffeine"};
    for (const std::string& look : looks) {
        SettlingBench bench(folder);
        measure(bench, look);
    }
    fs::remove_all(folder);
    return EXIT_SUCCESS;
}
