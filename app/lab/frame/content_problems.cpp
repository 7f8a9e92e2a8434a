#include "lab/frame/content_problems.h"

#include "signals/signal_table.h"

void report_content_problems(Workspace& work) {
    Diagnostics problems = work.media.problems();
    const auto add = [&problems](const Diagnostics& more) {
        problems.insert(problems.end(), more.begin(), more.end());
    };
    add(work.pictures.chosen().problems());
    if (work.document && work.document->look().driven_by == Driver::signal)
        add(notes_about(work.document->state().signal));
    work.messages.set_content_problems(problems);
}
