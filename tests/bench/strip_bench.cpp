// Cost of the window's picture and its views with the pass strip open, compared with the strip
// closed, with static values: two labs alternate. CPU time of the process. The strip updates five
// passes a second by wall time, so its share is too high on a busy machine.
#include "bench/bench_lab.h"
#include "bench/side_by_side.h"
#include "lab/views/displayed_passes.h"
#include "lab/views/views.h"

#include <fmt/format.h>

#include <cstdlib>

namespace fs = std::filesystem;

namespace {
const bench::Topic topic{"strip", "Pass strip: an update of the lab and its views at 1280 x 720"};

/// A lab with static values, and the views of its window.
class StripLab : public bench::BenchLab {
public:
    StripLab(const fs::path& folder, const std::string& look, bool shows_strip)
        : BenchLab(folder, {1280, 720}), m_views(Views::make().value()) {
        m_window.views.sizes.picture = {1280, 720};
        m_window.views.sizes.thumbnail_height = 64;
        m_window.layout.panels.hide(panel_id::inspector);
        if (!shows_strip)
            m_window.layout.panels.hide(panel_id::strip);
        m_lab->looks().open(look);
        m_lab->update(0.0);
        while (m_lab->loader().is_loading() || !m_lab->renderer() ||
               m_lab->player().transport().frame_number() < 5)
            update();
        specialize();
    }
    ~StripLab() { m_context->make_current(); }
    StripLab(const StripLab&) = delete;
    StripLab& operator=(const StripLab&) = delete;

    /// CPU time. Overdue work that accumulated while the other lab was measured is drawn first.
    double seconds_of(int updates) {
        constexpr int overdue = 2;
        m_context->make_current();
        for (int i = 0; i < overdue; ++i)
            update();
        const double start = bench::busy_seconds();
        for (int i = 0; i < updates; ++i)
            update();
        return bench::busy_seconds() - start;
    }

private:
    void specialize() {
        constexpr double longest = 0.1;  // of one update, so that the loop needs no waiting
        constexpr int max_updates = 300;
        for (int i = 0;
             i < max_updates && !m_lab->renderer()->executor().programs().is_specialized(); ++i)
            update(longest);
        for (int i = 0; i < 20; ++i)
            update();
    }

    void update(double seconds = 1.0 / 60.0) {
        m_lab->frames().set_displayed(displayed_passes(*m_lab, m_window));
        m_lab->update(seconds);
        while (m_lab->frames().has_unfinished_frame())
            m_lab->update(0.0);
        m_views.update(*m_lab, m_window);
        gpu::finish();
    }

    Views m_views;
    WindowState m_window;
};

void measure(const fs::path& folder, const std::string& look) {
    constexpr int rounds = 19;
    constexpr int updates = 8;
    const std::string name = fs::path(look).stem().string();
    StripLab closed(folder / "closed", look, false);
    StripLab open(folder / "open", look, true);
    bench::CostOfTurns cost(updates);
    double before = closed.seconds_of(updates);
    for (int i = 0; i < rounds; ++i) {
        const double between = open.seconds_of(updates);
        const double behind = closed.seconds_of(updates);
        cost.add(before, between, behind);
        before = behind;
    }
    bench::tell(topic,
                bench::ratio_figure(
                    name, fmt::format("{}: CPU time with the strip open, relative to closed", name),
                    cost.cost(), bench::at_most(1.10)));
}
}  // namespace

int main(int argc, char** argv) {
    std::string name = (fs::temp_directory_path() / "afterglow-bench-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    std::vector<std::string> looks(argv + 1, argv + argc);
    if (looks.empty())
        looks = {"presets/phosphor/article.json", "presets/phosphor/crisp-lab-scope.json", "crt"};
    for (const std::string& look : looks)
        measure(folder, look);
    fs::remove_all(folder);
    return EXIT_SUCCESS;
}
