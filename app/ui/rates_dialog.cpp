#include "ui/rates_dialog.h"

#include "ui/dialog_frame.h"
#include "ui/scoped.h"
#include "ui/theme.h"
#include "ui/widgets.h"
#include "ui/work_dialog.h"

#include <fmt/format.h>

void compare_rates(Edits& edits) {
    edits.add([](Lab& lab) { lab.compare_rates(); });
    edits.show({.kind = Dialog::Kind::rates});
}

namespace {
constexpr double most_levels = 255.0;

void draw_pairs(const RateComparison& comparison, const Scene& scene, Edits& edits) {
    const ScopedColor stripe(ImGuiCol_TableRowBgAlt, theme::field);
    if (!ImGui::BeginTable("##pairs", 4, ImGuiTableFlags_RowBg))
        return;
    ImGui::TableSetupColumn("Hz");
    ImGui::TableSetupColumn("largest");
    ImGui::TableSetupColumn("at pixel");
    ImGui::TableSetupColumn("mean");
    ImGui::TableHeadersRow();
    const ScopedFont font(scene.fonts.numbers);
    for (const RatePair& pair : comparison.pairs) {
        const Difference& apart = pair.difference;
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(fmt::format("{:.0f} – {:.0f}", pair.first, pair.second).c_str());
        edits.mark(fmt::format("rates:{:.0f}-{:.0f}", pair.first, pair.second));
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(fmt::format("{:.4g}", apart.largest * most_levels).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(fmt::format("{}, {}", apart.largest_x, apart.largest_y).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(fmt::format("{:.3f}", apart.mean * most_levels).c_str());
    }
    ImGui::EndTable();
}

void draw_comparison(const RateComparison& comparison, const Scene& scene, Edits& edits) {
    const RatePair& worst = comparison.worst();
    ImGui::TextUnformatted(
        wrapped(fmt::format("The largest difference is {:.4g} of 255 levels, between {:.0f} and "
                            "{:.0f} Hz at pixel {}, {}.",
                            worst.difference.largest * most_levels, worst.first, worst.second,
                            worst.difference.largest_x, worst.difference.largest_y),
                ImGui::GetContentRegionAvail().x)
            .c_str());
    edits.mark("rates_worst");
    ImGui::Spacing();
    draw_pairs(comparison, scene, edits);
    ImGui::Spacing();
    wrapped_dim_text(
        fmt::format("Each rate was drawn from a fresh start to {:.3g} s at {}; differences are in "
                    "levels of 255, of any colour.",
                    comparison.seconds, size_text(comparison.size)));
}
}  // namespace

void draw_rates_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("The picture at 24, 30, 60 and 144 Hz", 34.0f, scene, edits);
    if (!frame.is_open())
        return;
    const auto draw = [&](const auto& outcome) { draw_comparison(outcome, scene, edits); };
    draw_work(
        scene.lab.rate_check(), "Drawing the same moment at every rate", draw,
        [](Lab& lab) { lab.cancel_rate_comparison(); }, edits);
}
