#include "lab/media/fitted_source.h"

#include "lab/rendering/executors.h"
#include "model/picture/placing.h"

#include <utility>

void FittedSource::set(std::optional<Source> source) {
    m_source = std::move(source);
    m_shown.reset();
}

Extent FittedSource::extent(Extent viewport) const {
    return m_source ? placed_extent(m_source->extent(), m_source->spec(), viewport) : Extent{};
}

Result<bool> FittedSource::show(double seconds, Executors& executors) {
    if (!m_source)
        return false;
    m_source->expect(executors.picture().look().source_encoding);
    SharedPicture picture = m_source->picture_at(seconds);
    const Extent fitted = extent();
    if (picture == m_shown && fitted == m_shown_extent)
        return false;
    const auto set = show_placed(*picture, m_source->spec(), m_viewport, executors);
    m_shown = std::move(picture);
    m_shown_extent = fitted;
    return set ? Result<bool>(true) : fail(set.error());
}

Result<void> FittedSource::show_past(double seconds, Executors& executors) {
    if (!m_source || m_source->is_film() || m_source->is_live())
        return {};
    const auto shown = show(seconds, executors);
    return shown ? Result<void>() : fail(shown.error());
}

Result<void> FittedSource::show_again(double seconds, Executors& executors) {
    m_shown.reset();
    const auto shown = show(seconds, executors);
    return shown ? Result<void>() : fail(shown.error());
}

Result<void> FittedSource::show_in(double seconds, const Other& other) {
    if (!m_source)
        return {};
    SharedPicture picture = m_source->picture_at(seconds);
    if (picture == other.shown)
        return {};
    other.shown = std::move(picture);
    return show_placed(*other.shown, m_source->spec(), other.viewport, other.executors);
}

Result<void> FittedSource::show_past_in(double seconds, const Other& other) {
    if (!m_source || m_source->is_film() || m_source->is_live())
        return {};
    return show_in(seconds, other);
}
