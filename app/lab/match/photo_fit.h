#pragma once

#include "base/job_progress.h"
#include "lab/match/gauss_newton.h"
#include "lab/match/screen_renderer.h"

#include <functional>
#include <vector>

/// The parts of the picture that a fit compares.
struct Compared {
    bool has_tiles = true;
    bool has_points = true;
};

/// Fits unknowns to a photo by least squares. Keeps the light of the last drawn state.
class PhotoFit {
public:
    PhotoFit(ScreenRenderer& renderer, const Photo& photo, JobProgress& work)
        : m_renderer(renderer), m_photo(photo), m_work(work) {}

    /// See minimise() of gauss_newton.h.
    Result<double> minimise(MatchState& state, const std::vector<Unknown>& unknowns,
                            Compared compared, int steps, double precision = 1e-3);
    /// What the camera sees minus the photo: tiles, then points.
    Result<std::vector<float>> residuals(const MatchState& state, Compared compared);
    /// What the camera sees in the whole picture, in px of the look's picture and with the values
    /// of SampleValues. The edges are 0.
    Result<Picture> seen_picture(const MatchState& state);
    /// The photo in the same form.
    Picture photographed_picture(const Camera& camera) const;
    /// The mean square of the residuals.
    Result<double> cost(const MatchState& state, Compared compared);
    /// The share of the variance of luma in the photo that a state explains; 1: all.
    Result<double> explained_share(const MatchState& state, Compared compared);
    /// The derivatives at a state; the sum of the groups is complete without a prior.
    Result<std::vector<NormalEquations>> linearised(const MatchState& state,
                                                    const std::vector<Unknown>& unknowns,
                                                    Compared compared);
    ScreenRenderer& renderer() { return m_renderer; }
    const Photo& photo() const { return m_photo; }
    JobProgress& work() { return m_work; }

private:
    struct View;
    Result<const ScreenLight*> light_of(const Values& values);
    Result<Derivatives> column(const View& view, const Unknown& unknown);
    Derivatives moved_column(const View& view, const Unknown& unknown, double by) const;
    SampleLayout layout_for(Compared compared) const;
    Result<Derivatives> look_column(const View& view, const Unknown& unknown, double by);

    ScreenRenderer& m_renderer;
    const Photo& m_photo;
    JobProgress& m_work;
    Values m_drawn;
    ScreenLight m_light;
};
