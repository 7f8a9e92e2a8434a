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

PeriodFacts period_facts(const Parameter& parameter, double value, const PeriodTerms& terms) {
    PeriodFacts facts;
    facts.period = period_of(parameter, value, terms);
    const int length = std::max(terms.target.width, terms.target.height);
    constexpr double finest = 2.0;  // px, two samples per period (Nyquist)
    facts.is_too_fine = facts.period && *facts.period < finest;
    if (facts.period && !facts.is_too_fine)
        facts.beat = visible_beat(*facts.period, length);
    if (facts.beat || facts.is_too_fine)
        facts.even = even_value(parameter, value, terms);
    return facts;
}
