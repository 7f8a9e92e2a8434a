#include "lab/offline/non_finite_text.h"

#include <fmt/format.h>

Diagnostic diagnostic_of(const NonFinitePixel& trip, const Look& look) {
    const Pass& pass = look.passes[trip.pass];
    return {pass.declared.file, pass.declared.line,
            fmt::format("pass '{}' wrote NaN/Inf at pixel ({}, {}), frame {}", pass.name, trip.x,
                        trip.y, trip.frame),
            Severity::warning};
}
