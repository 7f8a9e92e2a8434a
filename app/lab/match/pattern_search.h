#pragma once

#include "lab/match/photo_fit.h"
#include "model/look/parameter.h"
#include "model/photo/period_spectrum.h"

#include <vector>

/// A state to choose from, and the mean square of its residuals.
struct Candidate {
    double cost;
    MatchState state;
};

/// Finds the periods of a look's patterns, its mask and its scanlines, in a photo. The period's
/// parameter and the amounts of the pattern share a group of the look.
class PatternSearch {
public:
    explicit PatternSearch(PhotoFit& fit) : m_fit(fit) {}

    /// The state with periods that the photo has and the picture without the pattern does not. The
    /// most likely comes first; at most `count`. The costs are those of the best amount.
    Result<std::vector<Candidate>> candidates(const MatchState& state, const Parameter& period,
                                              Along along, std::size_t count);
    /// The best of some values of a type, with the same period.
    Result<Candidate> best_type(const MatchState& state, const Parameter& period,
                                const std::vector<std::pair<const Parameter*, double>>& types);
    /// The amount of a pattern in the tiles, divided by its standard error. Tiles are independent.
    Result<double> evidence(const MatchState& state, const Parameter& period);
    /// A value of the period's parameter in px of the look's picture.
    double px_of(const MatchState& state, const Parameter& period, double value) const;

private:
    MatchState without_pattern(const MatchState& state, const Parameter& period) const;
    double min_period(const MatchState& state) const;
    Result<std::vector<double>> measured_values(const MatchState& state, const Parameter& period,
                                                Along along, std::size_t count);
    Result<double> value_with_period(MatchState state, const Parameter& parameter, Along along,
                                     double measured, const PeriodSpectrum& of_photo,
                                     const Picture& without);
    Result<Candidate> scanned(const MatchState& state, const Parameter& period, double value,
                              const std::vector<float>& without);

    PhotoFit& m_fit;
};
