#include "lab/compare/compared_pictures.h"

#include "gpu/objects/texels.h"
#include "graph/inspect/texel_programs.h"

#include <utility>
#include <vector>

ComparedPictures::ComparedPictures(Comparer comparer, RepeatedMeasurement distances,
                                   RepeatedMeasurement luminances)
    : m_comparer(std::move(comparer)),
      m_distances(std::move(distances)),
      m_luminances(std::move(luminances)) {}

Result<ComparedPictures> ComparedPictures::make() {
    auto comparer = Comparer::make();
    if (!comparer)
        return fail(comparer.error());
    auto distances = RepeatedMeasurement::make();
    if (!distances)
        return fail(distances.error());
    auto luminances = RepeatedMeasurement::make();
    if (!luminances)
        return fail(luminances.error());
    return ComparedPictures(std::move(*comparer), std::move(*distances), std::move(*luminances));
}

std::optional<double> ComparedPictures::stops() const {
    const auto& luminances = m_luminances.latest().luminances;
    if (!luminances)
        return std::nullopt;
    return matching_stops(luminances->ours, luminances->other);
}

void ComparedPictures::stop_measuring() {
    m_distances.stop();
    m_luminances.stop();
}

void ComparedPictures::stop() {
    stop_measuring();
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
    const bool is_integer = info_of(subject.other->format()).is_integer;
    if (is_integer || subject.other->extent() == subject.ours.extent())
        return subject.other;
    if (!fit_floats(m_fitted, subject.ours.extent()))
        return nullptr;
    m_fitted_from.reset();
    m_comparer.draw_fitted(*subject.other, subject.encoding, *m_fitted, subject.encoding);
    return &m_fitted->texture();
}

void ComparedPictures::match_brightness(const Pair& pair, double seconds) {
    m_luminances.update(seconds, [&](PairMeter& meter) { meter.start_luminances(pair); });
    const std::optional<double> brighter_by = stops();
    if (!brighter_by || !fit_floats(m_matched, pair.other.extent()))
        return;
    m_comparer.draw_brighter(pair.other, pair.encoding, *brighter_by, *m_matched);
    m_other = &m_matched->texture();
}

void ComparedPictures::draw_difference(const Pair& pair, const Comparison& comparison,
                                       double seconds) {
    constexpr double tolerance = 1.0 / 255.0;  // as in `afterglow compare`
    m_distances.update(seconds, [&](PairMeter& meter) { meter.start_distances(pair, tolerance); });
    m_has_difference = fit_floats(m_difference, pair.ours.extent());
    if (m_has_difference)
        m_comparer.draw_difference(pair, comparison.measure, *m_difference);
}

void ComparedPictures::update(const Subject& subject, const Comparison& comparison,
                              double seconds) {
    if (std::exchange(m_compared_with, comparison.other) != comparison.other)
        stop_measuring();  // the results belong to the previous reference
    m_has_difference = false;
    m_other = sized_other(subject);
    if (!m_other || !are_comparable(subject.ours, *m_other))
        return stop_measuring();
    if (comparison.has_equal_brightness)
        match_brightness({subject.ours, *m_other, subject.encoding}, seconds);
    else
        m_luminances.stop();
    if (comparison.mode == CompareMode::difference)
        draw_difference({subject.ours, *m_other, subject.encoding}, comparison, seconds);
    else
        m_distances.stop();
}
