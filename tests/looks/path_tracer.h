#pragma once

#include "lab/offline/offline.h"

#include <cmath>
#include <string>
#include <vector>

/// The look "caffeine" without a window, with its samples as linear light.
class PathTracer {
public:
    using Settings = std::vector<std::pair<std::string, std::string>>;

    /// Draws `batch` samples per frame; `settings` as for `--set`.
    static Result<PathTracer> create(Settings settings, Extent size, int batch) {
        auto roots = find_roots(std::filesystem::path(AFTERGLOW_SOURCE_DIR));
        if (!roots)
            return fail(roots.error());
        settings.emplace_back("samples_per_frame", std::to_string(batch));
        settings.emplace_back("converge", "1000000");
        auto prepared = prepare({.look = "caffeine", .values = std::move(settings)},
                                Library(std::move(*roots)));
        if (!prepared)
            return fail(prepared.error());
        auto offline = Offline::create(std::move(*prepared), size, 60.0);
        if (!offline)
            return fail(offline.error());
        return PathTracer(std::move(*offline), batch);
    }

    /// Specialises the programs for the current values.
    Result<void> specialize() {
        m_offline.make_current();
        return m_offline.specialize();
    }
    /// Draws one more batch, with any current context.
    void advance() {
        m_offline.make_current();
        m_offline.advance();
    }

    /// Continues up to `samples` in total, a multiple of the batch. Returns the mean light of each
    /// pixel, r g b.
    std::vector<double> light_after(int samples, const char* pass = "trace") {
        m_offline.make_current();
        while (m_offline.frame_number() * m_batch < samples)
            m_offline.advance();
        const Picture sum = target(pass);
        std::vector<double> light;
        for (std::size_t i = 0; i < sum.pixels.size(); i += 4)
            for (std::size_t channel = 0; channel < 3; ++channel)
                light.push_back(static_cast<double>(sum.pixels[i + channel]) /
                                static_cast<double>(sum.pixels[i + 3]));
        return light;
    }

    Picture target(const char* pass) const {
        return m_offline.picture(*find_pass(m_offline.executor().look(), pass));
    }

private:
    PathTracer(Offline offline, int batch) : m_offline(std::move(offline)), m_batch(batch) {}

    Offline m_offline;
    int m_batch;
};

/// Of the light of two pictures.
inline double mean_square_error(const std::vector<double>& a, const std::vector<double>& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (a[i] - b[i]) * (a[i] - b[i]);
    return squares / static_cast<double>(a.size());
}

inline double root_mean_square_error(const std::vector<double>& a, const std::vector<double>& b) {
    return std::sqrt(mean_square_error(a, b));
}
