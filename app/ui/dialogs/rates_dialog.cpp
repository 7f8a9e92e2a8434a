#include "ui/dialogs/rates_dialog.h"

#include "lab/jobs/background_jobs.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/work_dialog.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cmath>

void compare_rates(Edits& edits) {
    edits.change([](BackgroundJobs& jobs) { jobs.compare_rates(); });
    edits.show({.kind = Dialog::Kind::rates});
}

namespace {
constexpr double max_levels = 255.0;

void draw_pair(const RatePair& pair, std::size_t index, bool is_shown, Edits& edits) {
    const Difference& apart = pair.difference;
    ImGui::TableNextColumn();
    if (ImGui::Selectable(
            fmt::format("{:.0f} – {:.0f}", pair.first, pair.second).c_str(), is_shown,
            ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_DontClosePopups))
        edits.change([index](BackgroundJobs& jobs) { jobs.show_rate_pair(index); });
    edits.mark(fmt::format("rates:{:.0f}-{:.0f}", pair.first, pair.second));
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(fmt::format("{:.4g}", apart.largest * max_levels).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(fmt::format("{}, {}", apart.largest_x, apart.largest_y).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(fmt::format("{:.3f}", apart.mean * max_levels).c_str());
}

void draw_pairs(const RateComparison& comparison, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginTable("##pairs", 4))
        return;
    ImGui::TableSetupColumn("Hz");
    ImGui::TableSetupColumn("Largest");
    ImGui::TableSetupColumn("At pixel");
    ImGui::TableSetupColumn("Mean");
    ImGui::TableHeadersRow();
    const ScopedFont font(scene.fonts.numbers);
    const auto& shown = scene.lab.jobs.rate_pictures().shown();
    for (std::size_t i = 0; i < comparison.pairs.size(); ++i)
        draw_pair(comparison.pairs[i], i, shown && shown->pair == i, edits);
    ImGui::EndTable();
}

void draw_seen(const gpu::Texture& texture, const std::string& text, float width) {
    const Extent extent = texture.extent();
    ImGui::BeginGroup();
    dim_text(text);
    ImGui::Image(
        texture_id(texture.handle()),
        {width, width * static_cast<float>(extent.height) / static_cast<float>(extent.width)},
        {0.0f, 1.0f}, {1.0f, 0.0f});
    ImGui::EndGroup();
}

void draw_pictures(const RatePictures::Shown& shown, const RatePair& pair, Edits& edits) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f);
    draw_seen(shown.first, fmt::format("{:.0f} Hz", pair.first), width);
    ImGui::SameLine();
    draw_seen(shown.second, fmt::format("{:.0f} Hz", pair.second), width);
    ImGui::SameLine();
    draw_seen(shown.difference,
              shown.gain == 1.0 ? std::string("Difference")
                                : fmt::format("Difference, amplified {:g}×", shown.gain),
              width);
    edits.mark("rates_difference");
}

void draw_comparison(const RateComparison& comparison, const Scene& scene, Edits& edits) {
    const RatePair& worst = comparison.worst();
    ImGui::TextUnformatted(
        wrapped(fmt::format("The largest difference is {:.4g} of 255 levels, between {:.0f} Hz and "
                            "{:.0f} Hz at pixel ({}, {}).",
                            worst.difference.largest * max_levels, worst.first, worst.second,
                            worst.difference.largest_x, worst.difference.largest_y),
                ImGui::GetContentRegionAvail().x)
            .c_str());
    edits.mark("rates_worst");
    ImGui::Spacing();
    if (const auto& shown = scene.lab.jobs.rate_pictures().shown()) {
        draw_pictures(*shown, comparison.pairs[shown->pair], edits);
        ImGui::Spacing();
    }
    draw_pairs(comparison, scene, edits);
    ImGui::Spacing();
    wrapped_dim_text(
        fmt::format("Each frame rate was rendered from 0 to {:.3g} s at {}. Differences are in "
                    "8-bit levels: the largest of any channel, and the mean of all.",
                    comparison.seconds, size_text(comparison.size)));
}
}  // namespace

void draw_rates_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Compare frame rates", 60.0f, scene, edits);
    if (!frame.is_open())
        return;
    const auto draw = [&](const auto& outcome) { draw_comparison(outcome, scene, edits); };
    draw_work(
        scene.lab.jobs.rates(), "Rendering at 24, 30, 60 and 144 Hz…", draw,
        [](BackgroundJobs& jobs) { jobs.cancel_rates(); }, edits);
}
