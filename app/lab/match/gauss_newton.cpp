#include "lab/match/gauss_newton.h"

#include <algorithm>

namespace {
double prior_cost(const MatchState& state, const std::vector<Unknown>& unknowns, double noise) {
    double cost = 0.0;
    for (const Unknown& unknown : unknowns)
        if (unknown.deviation > 0.0) {
            const double miss = (unknown.of(state) - unknown.expected) / unknown.deviation;
            cost += 0.5 * noise * miss * miss;
        }
    return cost;
}

void add_prior(NormalEquations& sum, const MatchState& state, const std::vector<Unknown>& unknowns,
               double noise) {
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        if (const Unknown& unknown = unknowns[i]; unknown.deviation > 0.0) {
            const double weight = noise / (unknown.deviation * unknown.deviation);
            sum.squares[i * sum.n + i] += weight;
            sum.slopes[i] += weight * (unknown.of(state) - unknown.expected);
        }
}
}  // namespace

NormalEquations sum_of(const std::vector<NormalEquations>& groups) {
    NormalEquations sum(groups.front().n);
    for (const NormalEquations& group : groups)
        sum += group;
    return sum;
}

Result<double> minimise(LeastSquares& problem, MatchState& state,
                        const std::vector<Unknown>& unknowns, int steps, double precision) {
    auto now = problem.cost(state);
    if (!now)
        return now;
    double trust = 1.0;
    for (int step = 0; step < steps; ++step) {
        const auto groups = problem.linearised(state, unknowns);
        if (!groups)
            return fail(groups.error());
        NormalEquations sum = sum_of(*groups);
        const double noise = noise_variance(sum, *groups);
        const double count = sum.count;
        const double before = 0.5 * *now * count + prior_cost(state, unknowns, noise);
        add_prior(sum, state, unknowns, noise);
        bool is_better = false;
        double gain = 0.0;
        for (int attempt = 0; attempt < 4 && !is_better; ++attempt) {
            std::vector<double> low;
            std::vector<double> high;
            for (const Unknown& unknown : unknowns) {
                const double value = unknown.of(state);
                low.push_back(std::clamp(unknown.low - value, -trust * unknown.trust, 0.0));
                high.push_back(std::clamp(unknown.high - value, 0.0, trust * unknown.trust));
            }
            const std::vector<double> change = bounded_step(sum, low, high);
            MatchState next = state;
            for (std::size_t i = 0; i < unknowns.size(); ++i)
                unknowns[i].set(next, unknowns[i].of(state) + change[i]);
            const auto there = problem.cost(next);
            if (!there)
                return fail(there.error());
            const double after = 0.5 * *there * count + prior_cost(next, unknowns, noise);
            is_better = after < before;
            gain = 1.0 - after / before;
            if (is_better) {
                state = next;
                now = there;
                trust = std::min(2.0 * trust, 1.0);
            } else {
                trust *= 0.25;
            }
        }
        if (!is_better || gain < precision)
            break;
    }
    return now;
}
