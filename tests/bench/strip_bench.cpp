// What the window's picture and its views cost with the strip of thumbnails and gains open, against
// the same with the strip closed, values resting. CPU time of the process; the yardstick is
// measured twice, and where the two differ a run says little. The strip shows five passes a second
// by the clock on the wall: beside many other processes its share is too high.
#include "bench/bench_lab.h"
#include "bench/side_by_side.h"
#include "lab/views.h"

namespace fs = std::filesystem;

namespace {
class StripBench : public bench::BenchLab {
public:
    explicit StripBench(const fs::path& folder, const std::string& look)
        : BenchLab(folder, {1280, 720}), m_views(Views::make().value()) {
        m_window.views.picture = {1280, 720};
        m_window.views.thumbnail_height = 64;
        m_window.shows_inspector = false;
        m_lab->open(look);
        m_lab->update(0.0);
        while (m_lab->is_loading() || !m_lab->renderer() || m_lab->player().frame_number() < 5)
            turn();
    }

    /// CPU milliseconds of a turn once values have become constants.
    double turn_milliseconds(bool shows_strip) {
        constexpr int turns = 30;
        m_window.shows_strip = shows_strip;
        settle();
        const double start = bench::busy_seconds();
        for (int i = 0; i < turns; ++i)
            turn();
        return 1e3 * (bench::busy_seconds() - start) / turns;
    }

private:
    void settle() {
        constexpr double longest = 0.1;  // of a turn, so that it need not be waited for
        constexpr int most_turns = 300;
        turn();
        for (int i = 0; i < most_turns && !m_lab->renderer()->executor().is_settled(); ++i)
            turn(longest);
        for (int i = 0; i < 5; ++i)
            turn();
    }

    void turn(double seconds = 1.0 / 60.0) {
        m_lab->look_at(seen_passes(*m_lab, m_window));
        m_lab->update(seconds);
        while (m_lab->is_amid_frame())
            m_lab->update(0.0);
        m_views.update(*m_lab, m_window);
        gpu::finish();
    }

    Views m_views;
    WindowState m_window;
};
}  // namespace

int main(int argc, char** argv) {
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    fmt::print("A turn at 1280 x 720 with the strip open, against closed; CPU time:\n");
    std::vector<std::string> looks(argv + 1, argv + argc);
    if (looks.empty())
        looks = {"presets/phosphor/article.json", "presets/phosphor/crisp-lab-scope.json", "crt"};
    for (const std::string& look : looks) {
        constexpr int rounds = 7;
        StripBench bench(folder, look);
        std::vector<double> closed;
        std::vector<double> ratios;
        std::vector<double> itself;
        for (int i = 0; i < rounds; ++i) {
            const double before = bench.turn_milliseconds(false);
            const double open = bench.turn_milliseconds(true);
            const double behind = bench.turn_milliseconds(false);
            closed.push_back((before + behind) / 2.0);
            ratios.push_back(2.0 * open / (before + behind));
            itself.push_back(before / behind);
        }
        fmt::print("  {:<40} closed {:7.2f} ms   open / closed {:.3f}   itself {:.3f}\n", look,
                   bench::median(closed), bench::median(ratios), bench::median(itself));
        std::fflush(stdout);
    }
    fs::remove_all(folder);
    return EXIT_SUCCESS;
}
