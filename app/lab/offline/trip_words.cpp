#include "lab/offline/trip_words.h"

#include <fmt/format.h>

Diagnostic diagnostic_of(const Trip& trip, const Look& look) {
    const Pass& pass = look.passes[trip.pass];
    return {pass.declared.file, pass.declared.line,
            fmt::format("pass '{}' wrote NaN/Inf at pixel ({}, {}), frame {}", pass.name, trip.x,
                        trip.y, trip.frame),
            Severity::warning};
}
