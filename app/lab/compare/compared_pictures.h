#pragma once

#include "graph/compare/comparer.h"
#include "lab/compare/repeated_measurement.h"
#include "model/preset/comparison.h"

#include <memory>
#include <optional>

/// The reference of a comparison as displayed: fitted to the picture, with equal brightness if
/// requested, and the difference of both.
class ComparedPictures {
public:
    static Result<ComparedPictures> make();

    struct Subject {
        const gpu::Texture& ours;
        const gpu::Texture* other = nullptr;       // null: the reference
        std::shared_ptr<const Picture> reference;  // if `other` is null
        Encoding encoding = Encoding::display;     // of ours and the other
    };
    /// Call in every update during a comparison.
    void update(const Subject& subject, const Comparison& comparison, double seconds);
    /// Ends the comparison.
    void stop();

    /// The reference to display; null: none. Valid until the next update.
    const gpu::Texture* other() const { return m_other; }
    /// The difference, number by number; null if it is not requested, or if the formats are not
    /// comparable.
    const gpu::Texture* difference() const {
        return m_has_difference ? &m_difference->texture() : nullptr;
    }
    /// nullopt until available.
    const std::optional<Distances>& distances() const { return m_distances.latest().distances; }
    /// The exposure of the reference in stops.
    std::optional<double> stops() const;

private:
    ComparedPictures(Comparer comparer, RepeatedMeasurement distances,
                     RepeatedMeasurement luminances);
    const gpu::Texture* sized_other(const Subject& subject);
    const gpu::Texture* reference(const Subject& subject);
    void stop_measuring();
    void match_brightness(const Pair& pair, double seconds);
    void draw_difference(const Pair& pair, const Comparison& comparison, double seconds);

    Comparer m_comparer;
    RepeatedMeasurement m_distances;
    RepeatedMeasurement m_luminances;
    std::shared_ptr<const Picture> m_uploaded;
    std::optional<gpu::Texture> m_reference;
    std::optional<gpu::Canvas> m_fitted;
    std::shared_ptr<const Picture> m_fitted_from;  // null: m_fitted holds a picture that is redrawn
    std::optional<gpu::Canvas> m_matched;
    std::optional<gpu::Canvas> m_difference;
    bool m_has_difference = false;
    const gpu::Texture* m_other = nullptr;
    Other m_compared_with;
};
