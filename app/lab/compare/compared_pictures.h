#pragma once

#include "graph/compare/comparer.h"
#include "graph/compare/pair_meter.h"
#include "model/preset/comparison.h"

#include <memory>
#include <optional>

/// The other picture of a comparison as it is shown: fitted to ours, as bright as ours where that
/// is asked for, and how far the two are apart. Measured at most five times a second, and where
/// that is slow for less than a tenth of the time; nobody waits for the answer.
class ComparedPictures {
public:
    static Result<ComparedPictures> make();

    struct Subject {
        const gpu::Texture& ours;
        const gpu::Texture* other = nullptr;       // null: the reference
        std::shared_ptr<const Picture> reference;  // where there is no other
        Encoding encoding = Encoding::display;     // of ours and the other
    };
    /// To be called every turn in which something is compared.
    void update(const Subject& subject, const Comparison& comparison, double seconds);
    /// Nobody compares any more.
    void stop();

    /// As it is to be seen beside ours; null: there is none. Good until the next update.
    const gpu::Texture* other() const { return m_other; }
    /// How far the two are apart, number by number; null where that is not asked for, or where they
    /// cannot be told apart.
    const gpu::Texture* difference() const {
        return m_has_difference ? &m_difference->texture() : nullptr;
    }
    /// None until they have come.
    const std::optional<Distances>& distances() const { return m_distances; }
    /// By which the other picture's light is multiplied.
    const std::optional<double>& stops() const { return m_stops; }

private:
    ComparedPictures(Comparer comparer, PairMeter distances, PairMeter light);
    const gpu::Texture* sized_other(const Subject& subject);
    const gpu::Texture* reference(const Subject& subject);
    void forget_numbers();
    void match_brightness(const Pair& pair, double seconds);
    void tell_apart(const Pair& pair, const Comparison& comparison, double seconds);

    // When something is to be measured anew.
    struct Pace {
        std::optional<double> due;  // s; none: at once
        bool is_due(double seconds) const { return !due || seconds >= *due; }
        template <class Act>
        void run(double seconds, Act act);
    };

    Comparer m_comparer;
    PairMeter m_distance_meter;
    PairMeter m_light_meter;
    std::shared_ptr<const Picture> m_uploaded;
    std::optional<gpu::Texture> m_reference;
    std::optional<gpu::Canvas> m_fitted;
    std::shared_ptr<const Picture> m_fitted_from;  // null: what is in m_fitted moves
    std::optional<gpu::Canvas> m_matched;
    std::optional<gpu::Canvas> m_difference;
    bool m_has_difference = false;
    const gpu::Texture* m_other = nullptr;
    std::optional<Distances> m_distances;
    std::optional<double> m_stops;
    Other m_compared_with;
    Pace m_distance_pace;
    Pace m_light_pace;
};
