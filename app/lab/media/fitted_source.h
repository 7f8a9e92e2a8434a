#pragma once

#include "lab/media/source.h"

#include <optional>

/// The source of a look, fitted into the render size, and the picture of it that the executors
/// have.
class FittedSource {
public:
    /// Null: no source.
    const Source* get() const { return m_source ? &*m_source : nullptr; }
    /// Null: no source.
    Source* get() { return m_source ? &*m_source : nullptr; }
    void set(std::optional<Source> source);
    /// The render size into which the source is fitted.
    void set_viewport(Extent viewport) { m_viewport = viewport; }
    /// The size of the source as the look reads it; empty: no source.
    Extent extent() const { return extent(m_viewport); }
    Extent extent(Extent viewport) const;
    /// Whether show() used an outdated picture.
    bool is_late() const { return m_source && m_source->is_late(); }

    /// Sets the source for the end time of a frame; true if the picture changed. A
    /// picture that is still being read is late.
    Result<bool> show(double seconds, Executors& executors);
    /// The same for a replayed frame. A film and a live
    /// source keep their current picture.
    Result<void> show_past(double seconds, Executors& executors);
    /// As show(), for executors that have lost their source.
    Result<void> show_again(double seconds, Executors& executors);

    /// Other executors, such as those of previews: their picture size and current source picture.
    struct Other {
        Executors& executors;
        Extent viewport;
        SharedPicture& shown;
    };
    /// As show() and show_past().
    Result<void> show_in(double seconds, const Other& other);
    Result<void> show_past_in(double seconds, const Other& other);

private:
    std::optional<Source> m_source;
    Extent m_viewport;
    SharedPicture m_shown;  // the source picture of the executors
    Extent m_shown_extent;
};
