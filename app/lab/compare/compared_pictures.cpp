#include "lab/compare/compared_pictures.h"

#include "base/elapsed.h"
#include "gpu/objects/texels.h"
#include "graph/inspect/texel_programs.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

ComparedPictures::ComparedPictures(Comparer comparer, PairMeter distances, PairMeter light)
    : m_comparer(std::move(comparer)),
      m_distance_meter(std::move(distances)),
      m_light_meter(std::move(light)) {}

Result<ComparedPictures> ComparedPictures::make() {
    auto comparer = Comparer::make();
    if (!comparer)
        return fail(comparer.error());
    auto distances = PairMeter::make();
    if (!distances)
        return fail(distances.error());
    auto light = PairMeter::make();
    if (!light)
        return fail(light.error());
    return ComparedPictures(std::move(*comparer), std::move(*distances), std::move(*light));
}

template <class Act>
void ComparedPictures::Pace::run(double seconds, Act act) {
    constexpr double pause_seconds = 0.2;
    constexpr double most_share = 0.1;  // of the time
    if (!is_due(seconds))
        return;
    const auto start = std::chrono::steady_clock::now();
    act();
    due = seconds + std::max(pause_seconds, seconds_since(start) / most_share);
}

void ComparedPictures::forget_numbers() {
    m_distance_meter.stop();
    m_light_meter.stop();
    m_distances.reset();
    m_stops.reset();
    m_distance_pace = {};
    m_light_pace = {};
}

void ComparedPictures::stop() {
    forget_numbers();
    m_uploaded.reset();
    m_reference.reset();
    m_fitted.reset();
    m_fitted_from.reset();
    m_matched.reset();
    m_difference.reset();
    m_has_difference = false;
    m_other = nullptr;
}

// A reference of the picture's size keeps the numbers of its file.
const gpu::Texture* ComparedPictures::reference(const Subject& subject) {
    const auto& picture = subject.reference;
    if (!picture)
        return nullptr;
    if (m_uploaded != picture) {
        auto texture = gpu::texture_of(*picture, Format::rgba32f, picture->encoding);
        m_reference = texture ? std::optional(std::move(*texture)) : std::nullopt;
        m_uploaded = picture;
        m_fitted.reset();
    }
    const Extent extent = subject.ours.extent();
    if (!m_reference || (picture->extent == extent && picture->encoding == subject.encoding))
        return m_reference ? &*m_reference : nullptr;
    const bool is_there =
        m_fitted && m_fitted->texture().extent() == extent && m_fitted_from == picture;
    if (is_there)
        return &m_fitted->texture();
    if (!fit_floats(m_fitted, extent))
        return nullptr;
    m_comparer.draw_fitted(*m_reference, picture->encoding, *m_fitted, subject.encoding);
    m_fitted_from = picture;
    return &m_fitted->texture();
}

const gpu::Texture* ComparedPictures::sized_other(const Subject& subject) {
    if (!subject.other)
        return reference(subject);
    const bool is_integer = facts_of(subject.other->format()).is_integer;
    if (is_integer || subject.other->extent() == subject.ours.extent())
        return subject.other;
    if (!fit_floats(m_fitted, subject.ours.extent()))
        return nullptr;
    m_fitted_from.reset();
    m_comparer.draw_fitted(*subject.other, subject.encoding, *m_fitted, subject.encoding);
    return &m_fitted->texture();
}

void ComparedPictures::match_brightness(const Pair& pair, double seconds) {
    if (const auto measured = m_light_meter.take(); measured && measured->luminances)
        m_stops = matching_stops(measured->luminances->ours, measured->luminances->other);
    if (!m_light_meter.is_busy())
        m_light_pace.run(seconds, [&] { m_light_meter.start_luminances(pair); });
    if (!m_stops || !fit_floats(m_matched, pair.other.extent()))
        return;
    m_comparer.draw_brighter(pair.other, pair.encoding, *m_stops, *m_matched);
    m_other = &m_matched->texture();
}

void ComparedPictures::tell_apart(const Pair& pair, const Comparison& comparison, double seconds) {
    constexpr double tolerance = 1.0 / 255.0;  // as in `afterglow compare`
    if (const auto measured = m_distance_meter.take(); measured && measured->distances)
        m_distances = measured->distances;
    if (!m_distance_meter.is_busy())
        m_distance_pace.run(seconds, [&] { m_distance_meter.start_distances(pair, tolerance); });
    m_has_difference = fit_floats(m_difference, pair.ours.extent());
    if (m_has_difference)
        m_comparer.draw_difference(pair, comparison.measure, *m_difference);
}

void ComparedPictures::update(const Subject& subject, const Comparison& comparison,
                              double seconds) {
    if (std::exchange(m_compared_with, comparison.other) != comparison.other)
        forget_numbers();  // they belong to the previous reference
    m_has_difference = false;
    m_other = sized_other(subject);
    if (!m_other || !are_comparable(subject.ours, *m_other)) {
        m_distances.reset();
        m_stops.reset();
        return;
    }
    if (comparison.has_equal_brightness) {
        match_brightness({subject.ours, *m_other, subject.encoding}, seconds);
    } else {
        m_light_meter.stop();
        m_stops.reset();
        m_light_pace = {};
    }
    if (comparison.mode == CompareMode::difference) {
        tell_apart({subject.ours, *m_other, subject.encoding}, comparison, seconds);
    } else {
        m_distance_meter.stop();
        m_distances.reset();
        m_distance_pace = {};
    }
}
