#include "lab/document/cued_values.h"

#include <utility>

void apply_cues(Document& document, const CuePlan& plan, double position) {
    const DocumentState& now = document.state();
    CuedState cued = plan.state_at(document.look(), {now.values, now.modulations}, position);
    document.amend([&](DocumentState& state) {
        state.values = std::move(cued.values);
        state.modulations = std::move(cued.modulations);
    });
}
