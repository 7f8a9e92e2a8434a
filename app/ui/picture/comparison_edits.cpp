#include "ui/picture/comparison_edits.h"

#include "lab/frame/frame_loop.h"

void set_compare_mode(CompareMode mode, Edits& edits) {
    edits.change([mode](ComparisonView& comparison) { comparison.set_mode(mode); });
}

// Changes the comparison that is current when the edit is applied. One frame can contain two keys.
void change_comparison(Edits& edits, const std::function<void(Comparison&)>& change) {
    edits.change([change](ComparisonView& comparison) {
        Comparison next = comparison.selection().chosen();
        change(next);
        comparison.choose(next);
    });
}
