#include "ui/picture/comparison_edits.h"

#include "lab/lab.h"

void set_compare_mode(CompareMode mode, Edits& edits) {
    edits.add([mode](Lab& lab) { lab.frames().comparison().set_mode(mode); });
}

// Changes the comparison that is current when the edit is applied. One frame can contain two keys.
void change_comparison(Edits& edits, const std::function<void(Comparison&)>& change) {
    edits.add([change](Lab& lab) {
        Comparison next = lab.frames().comparison().selection().chosen();
        change(next);
        lab.frames().comparison().choose(next);
    });
}
