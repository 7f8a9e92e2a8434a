#pragma once

#include "gpu/input_event.h"
#include "lab/storage/background_work.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cmath>

/// Content of a dialog for background work. While it runs: `doing` and the progress. Then `draw`
/// shows its outcome, or the error is shown. Closing the dialog runs the edit `cancel`.
template <class Outcome, class Draw, class Cancel>
void draw_work(const BackgroundWork<Outcome>& work, const char* doing, const Draw& draw,
               const Cancel& cancel, Edits& edits) {
    const bool is_running = work.is_running();
    if (is_running) {
        dim_text(doing);
        ImGui::ProgressBar(static_cast<float>(work.share()), {-1.0f, 0.0f});
        edits.mark("dialog_progress");
        if (const auto left = work.seconds_left())
            dim_text(fmt::format("{:.0f} s left", std::ceil(*left)));
    } else if (work.outcome() && work.outcome()->has_value()) {
        draw(**work.outcome());
    } else if (work.outcome()) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextWrapped("%s", work.outcome()->error().front().message.c_str());
    }
    const bool is_left = draw_close_button(is_running ? "Cancel" : "Close", edits, !is_running);
    if (is_left || ImGui::IsKeyPressed(gpu::key::escape, false))
        edits.change(cancel);
}
