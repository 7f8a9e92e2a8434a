#pragma once

#include "base/job_progress.h"
#include "lab/match/beam_renderer.h"
#include "lab/match/gauss_newton.h"
#include "lab/match/match_pictures.h"

#include <vector>

/// A line or dot in a photo, and how it is drawn in the middle of a picture.
struct BeamPattern {
    BeamPlace photographed;  // px of the photo
    double reach = 0.0;      // of its profile, px of the photo
    glm::dvec2 along{0.0};   // in the picture, as in BeamPlace
    double scale = 1.0;      // px of the picture per px of the photo
};

/// `lines`: px that the height of the screen has in the picture.
BeamPattern pattern_at(const BeamPlace& photographed, double reach, const Camera& camera,
                       Extent photo, int lines);

/// Compares profiles of lines and dots in a photo with those of a look. The look draws each as
/// bright as the photo shows it. Gain and background are those that fit best.
class BeamFit : public LeastSquares {
public:
    BeamFit(BeamRenderer& renderer, const LightMap& photo, const std::vector<BeamPattern>& patterns,
            JobProgress& work);

    Result<double> cost(const MatchState& state) override;
    Result<std::vector<NormalEquations>> linearised(const MatchState& state,
                                                    const std::vector<Unknown>& unknowns) override;
    /// The share of the variance of light that a state explains; 1: all.
    Result<double> explained_share(const MatchState& state);
    /// The surroundings of each line and dot, side by side, without colour.
    Result<MatchPictures> pictures(const MatchState& state);

private:
    struct Compared {
        BeamPattern pattern;
        BeamProfile photo;
        std::vector<double> mean;     // of the photo's pieces
        std::vector<double> weights;  // of the residuals
        double seconds = 1e-5;        // that the beam was on in the last flash
    };
    // What the camera sees of a pattern.
    struct Seen {
        LightMap light;  // around the pattern, with the camera's blur
        BeamPlace place;
        std::vector<double> profile;
        double gain = 1.0;
        double background = 0.0;
    };
    Result<Seen> seen(const MatchState& state, Compared& compared);
    Result<Seen> flash(const MatchState& state, const Compared& compared);
    Result<std::vector<float>> residuals(const MatchState& state);

    BeamRenderer& m_renderer;
    const LightMap& m_photo;
    JobProgress& m_work;
    std::vector<Compared> m_compared;
};
