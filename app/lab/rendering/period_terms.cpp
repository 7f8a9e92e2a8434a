#include "lab/rendering/period_terms.h"

#include "lab/document/document.h"
#include "lab/rendering/renderer.h"

#include <algorithm>

PeriodTerms period_terms(const Parameter& parameter, const Document& document,
                         const Renderer* renderer) {
    PeriodTerms terms{document.look(), document.values(), {}, {}};
    if (!renderer || parameter.bindings.empty())
        return terms;
    const auto pass = static_cast<std::size_t>(parameter.bindings.front().pass);
    const Executor& executor = renderer->executor();
    if (pass >= executor.plan().targets.size() || pass >= executor.look().passes.size())
        return terms;
    terms.target = executor.plan().targets[pass].extent;
    const bool reads_source = executor.look().passes[pass].source.empty();
    terms.raster = reads_source && renderer->executors().inputs().source_raster
                       ? *renderer->executors().inputs().source_raster
                       : own_raster(terms.target);
    return terms;
}

PeriodInfo period_info(const Parameter& parameter, double value, const PeriodTerms& terms) {
    PeriodInfo info;
    info.period = period_of(parameter, value, terms);
    const int length = std::max(terms.target.width, terms.target.height);
    constexpr double finest = 2.0;  // px, two samples per period (Nyquist)
    info.is_too_fine = info.period && *info.period < finest;
    if (info.period && !info.is_too_fine)
        info.beat = visible_beat(*info.period, length);
    if (info.beat || info.is_too_fine)
        info.even = whole_period_value(parameter, value, terms);
    return info;
}
