#pragma once

#include "bench/figure.h"
#include "bench/wanted.h"
#include "gpu/headless_context.h"
#include "lab/lab.h"

#include <chrono>
#include <memory>

namespace bench {

/// A lab without a window, with the looks of the source tree and its own folder for everything
/// else. Ends the program if GL is missing.
class BenchLab {
public:
    BenchLab(const std::filesystem::path& folder, Extent picture) {
        m_context = wanted(gpu::create_headless_context());
        tell_driver(m_context->info());
        auto worker = wanted(gpu::Context::shared_with(*m_context));
        Roots roots{AFTERGLOW_SOURCE_DIR, folder / "user", folder / "state", folder / "cache"};
        m_lab = std::make_unique<Lab>(Library(std::move(roots)), *m_context, std::move(worker));
        m_lab->work().size.choose({false, picture, 1.0});
    }
    ~BenchLab() { m_lab.reset(); }
    BenchLab(const BenchLab&) = delete;
    BenchLab& operator=(const BenchLab&) = delete;

protected:
    /// Waits for the deferred work after the first picture, which is not part of the cost of a
    /// frame.
    template <class Draw>
    static void until_ready(Draw draw) {
        constexpr auto timeout = std::chrono::seconds(3);
        for (const auto start = std::chrono::steady_clock::now();
             std::chrono::steady_clock::now() - start < timeout;)
            draw();
    }

    std::unique_ptr<gpu::Context> m_context;
    std::unique_ptr<Lab> m_lab;
};

}  // namespace bench
