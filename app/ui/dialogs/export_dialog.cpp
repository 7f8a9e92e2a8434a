#include "ui/dialogs/export_dialog.h"

#include "lab/document/output_name.h"
#include "lab/jobs/background_jobs.h"
#include "lab/offline/export_plan.h"
#include "lab/rendering/named_size.h"
#include "lab/sequencer/sequencer.h"
#include "lab/storage/local_date.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/dialog_rows.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
ExportFacts facts_of(const Scene& scene) {
    const Renderer* renderer = scene.lab.renderer;
    return {.document = *scene.lab.document,
            .queue = scene.lab.jobs.exports(),
            .render_size = scene.lab.size.extent(),
            .signal = scene.lab.player.signal().spec(),
            .sound_seconds = scene.lab.player.signal().sound_seconds(),
            .frame_milliseconds = renderer ? renderer->times().passes().current_total() : 0.0,
            .plays_cues = scene.lab.sequencer.cues().plan() != nullptr};
}

/// The rows of the dialog. They change a copy of the form.
class ExportRows {
public:
    ExportRows(const ExportPlan& plan, const ExportFacts& facts, ExportForm& form, Edits& edits)
        : m_plan(plan), m_facts(facts), m_form(form), m_edits(edits) {}

    void draw(bool is_new) {
        draw_file(is_new);
        draw_size();
        draw_time();
        draw_rate();
        draw_codec();
        draw_sound();
        draw_alpha();
        draw_hdr();
        draw_subframes();
    }

private:
    float room() const { return ImGui::GetContentRegionAvail().x; }
    float number_width() const { return ImGui::GetFontSize() * 7.0f; }
    void problem(ExportField field) const { dialog_row_problem(m_plan.problem_of(field), m_edits); }

    void draw_file(bool is_new) {
        const float kind_width = ImGui::GetFontSize() * 9.0f;
        dialog_row("File name");
        if (is_new)
            ImGui::SetKeyboardFocusHere();
        m_form.file = dialog_text("dialog_file", m_form.file, "Name or path",
                                  room() - kind_width - ImGui::GetStyle().ItemSpacing.x, m_edits);
        ImGui::SameLine();
        std::vector<std::string> labels;
        for (const ExportKind& kind : export_kinds())
            labels.push_back(kind.label);
        const auto kind = export_kind_of(m_form.file);
        const std::size_t before = kind.value_or(labels.size());
        const std::size_t chosen = dialog_list("export_kind", labels, before, kind_width, m_edits);
        if (chosen != before) {
            m_form.file = with_export_kind(m_form.file, export_kinds()[chosen]);
            m_form.codec.clear();
            m_form.sound.clear();
            m_form.quality.clear();
        }
        {
            const ScopedDisabled disabled(has_own_folder(m_form.file));
            dialog_row("Folder");
            m_form.folder =
                dialog_text("dialog_folder", m_form.folder.string(), "", room(), m_edits);
        }
        problem(ExportField::file);
    }

    void draw_size() {
        const auto& sizes = named_sizes();
        std::vector<std::string> labels{
            fmt::format("Render size ({})", size_text(m_facts.render_size))};
        for (const NamedSize& size : sizes)
            labels.push_back(fmt::format("{} ({})", size.label, size_text(size.extent)));
        labels.emplace_back("Custom");
        const auto named = std::ranges::find(sizes, m_form.size, &NamedSize::name);
        const std::size_t before = m_form.has_own_size ? labels.size() - 1
                                   : m_form.size.empty()
                                       ? 0
                                       : static_cast<std::size_t>(named - sizes.begin()) + 1;
        dialog_row("Size");
        const std::size_t chosen =
            dialog_list("export_size", labels, before, ImGui::GetFontSize() * 16.0f, m_edits);
        if (chosen != before) {
            m_form.has_own_size = chosen + 1 == labels.size();
            m_form.size = chosen == 0           ? ""
                          : m_form.has_own_size ? fmt::format("{}x{}", m_facts.render_size.width,
                                                              m_facts.render_size.height)
                                                : sizes[chosen - 1].name;
        }
        if (m_form.has_own_size) {
            ImGui::SameLine();
            m_form.size =
                dialog_text("export_own_size", m_form.size, "1280x720", number_width(), m_edits);
        }
        problem(ExportField::size);
    }

    void draw_time() {
        dialog_row("Loop");
        ImGui::Checkbox("Exactly one period, after the look has settled", &m_form.loops);
        m_edits.mark("export_loop");
        {
            const ScopedDisabled disabled(m_form.loops);
            dialog_row("Start");
            m_form.start = dialog_text("export_start", m_form.start, "0", number_width(), m_edits);
            ImGui::SameLine();
            dim_text("s");
        }
        problem(ExportField::start);
        dialog_row(m_form.loops ? "Period" : "Length");
        m_form.length =
            dialog_text("export_seconds", m_form.length, length_hint(), number_width(), m_edits);
        ImGui::SameLine();
        dim_text(m_form.loops ? "s. Leave empty to detect the period." : "s");
        problem(ExportField::length);
    }

    std::string length_hint() const {
        if (m_form.loops)
            return "automatic";
        if (m_facts.sound_seconds <= 0.0 && m_facts.draws_video())
            return "video";
        const double usual = m_facts.sound_seconds > 0.0
                                 ? m_facts.sound_seconds - m_plan.settings.start
                                 : film_seconds_without_sound;
        return fmt::format("{:.4g}", std::max(usual, 0.0));
    }

    void draw_rate() {
        dialog_row("Frame rate");
        m_form.fps = dialog_text("export_fps", m_form.fps, "60", number_width(), m_edits);
        ImGui::SameLine();
        dim_text("fps");
        for (const char* rate : {"24", "25", "30", "50", "60"}) {
            ImGui::SameLine();
            if (quiet_button(rate))
                m_form.fps = rate;
            m_edits.mark(std::string("export_fps:") + rate);
        }
        problem(ExportField::fps);
    }

    // A list of choices that may have nothing to choose.
    std::string chosen_of(const char* id, const std::vector<ExportChoice>& choices,
                          const std::string& name) {
        const ScopedDisabled disabled(choices.empty());
        std::vector<std::string> labels;
        for (const ExportChoice& choice : choices)
            labels.push_back(choice.label);
        if (choices.empty())
            labels.emplace_back("Set by the file type");
        const auto current = std::ranges::find(choices, name, &ExportChoice::name);
        const auto before = static_cast<std::size_t>(current - choices.begin());
        const std::size_t chosen =
            dialog_list(id, labels, before, ImGui::GetFontSize() * 16.0f, m_edits);
        return chosen < choices.size() ? choices[chosen].name : name;
    }

    void draw_codec() {
        dialog_row("Codec");
        const std::string before = m_form.codec;
        m_form.codec =
            chosen_of("export_codec", codec_choices(m_plan.settings.file, m_plan.settings.film),
                      m_form.codec);
        if (m_form.codec != before)
            m_form.quality.clear();
        problem(ExportField::codec);
        const std::string hint = quality_hint(m_plan.settings);
        const bool has_none = hint.empty() && m_form.quality.empty();
        dialog_row("Quality");
        const ScopedDisabled disabled(has_none);
        m_form.quality = dialog_text("export_quality", m_form.quality, has_none ? "none" : hint,
                                     ImGui::GetFontSize() * 16.0f, m_edits);
        problem(ExportField::quality);
    }

    void draw_sound() {
        dialog_row("Sound");
        if (m_facts.sound_seconds <= 0.0 && !m_facts.draws_video()) {
            dim_text("The signal has no sound.");
            return;
        }
        m_form.sound = chosen_of("export_sound", sound_choices(m_plan.settings.file), m_form.sound);
        problem(ExportField::sound);
    }

    void draw_alpha() {
        dialog_row("Alpha");
        ImGui::Checkbox("Keep transparency", &m_form.keeps_alpha);
        m_edits.mark("export_alpha");
        tooltip("A look without transparency becomes transparent where it is black.");
        problem(ExportField::alpha);
    }

    void draw_hdr() {
        const ScopedDisabled disabled(!is_film_name(m_plan.settings.file));
        dialog_row("HDR");
        m_form.hdr = dialog_list("export_hdr", hdr_choices(), m_form.hdr, number_width(), m_edits);
        if (m_form.hdr > 0) {
            dialog_row("Paper white");
            draw_nits("export_paper_white", HdrLight{}.paper_white, m_form.paper_white);
            dialog_row("Peak");
            draw_nits("export_peak", HdrLight{}.peak, m_form.peak);
        }
        problem(ExportField::hdr);
    }

    void draw_nits(const char* id, double usual, std::string& text) {
        text = dialog_text(id, text, fmt::format("{:.0f}", usual), number_width(), m_edits);
        ImGui::SameLine();
        dim_text("nits");
    }

    void draw_subframes() {
        if (!m_facts.has_subframes())
            return;
        const ScopedDisabled disabled(m_form.loops);
        dialog_row("Sub-frames");
        ImGui::Checkbox("Each one a frame", &m_form.has_subframes);
        m_edits.mark("export_subframes");
        tooltip(
            "Without it, each frame is a whole source frame. The frame rate counts sub-frames.");
    }

    const ExportPlan& m_plan;
    const ExportFacts& m_facts;
    ExportForm& m_form;
    Edits& m_edits;
};

std::string duration_text(double seconds) {
    if (seconds < 90.0)
        return fmt::format("{:.0f} s", std::max(std::ceil(seconds), 1.0));
    if (seconds < 5400.0)
        return fmt::format("{:.0f} min", seconds / 60.0);
    return fmt::format("{:.1f} h", seconds / 3600.0);
}

void draw_summary(const ExportPlan& plan, const ExportFacts& facts) {
    const Extent size = plan.settings.size.is_empty() ? facts.render_size : plan.settings.size;
    std::string text = size_text(size);
    if (plan.frames > 0)
        text = fmt::format("{} frame{} · {}", plan.frames, plan.frames == 1 ? "" : "s", text);
    if (plan.work_seconds > 0.0)
        text += fmt::format(" · about {} to render", duration_text(plan.work_seconds));
    ImGui::Spacing();
    dim_text(text);
    if (plan.replaces)
        dim_text("This file exists and will be replaced.");
    if (plan.note.empty())
        return;
    const ScopedColor color(ImGuiCol_Text, theme::warning);
    ImGui::TextUnformatted(wrapped(plan.note, ImGui::GetContentRegionAvail().x).c_str());
}

void start(const ExportPlan& plan, Edits& edits) {
    close_dialog(edits);
    edits.arrange([folder = plan.settings.file.parent_path()](WindowState& window) {
        window.exporting.folder = folder;
        window.file_dialogs.folders["video"] = folder;
    });
    edits.change([settings = plan.settings](const Sequencer& sequencer, BackgroundJobs& jobs) {
        jobs.export_frames(settings, sequencer.cues().plan());
    });
}
}  // namespace

void draw_export_dialog(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return close_dialog(edits);
    const DialogFrame frame("Export video or image sequence", 38.0f, scene, edits);
    if (!frame.is_open())
        return;
    const ExportFacts facts = facts_of(scene);
    const bool is_new = scene.window.dialog.is_new;
    ExportForm form = scene.window.exporting;
    if (is_new) {
        if (form.folder.empty())
            form.folder = last_folder(scene.window.file_dialogs, "video", UserFolder::videos);
        form = initial_export_form(form, facts, local_date());
    }
    const ExportPlan plan = planned_export(form, facts);
    ExportRows(plan, facts, form, edits).draw(is_new);
    draw_summary(plan, facts);
    edits.arrange([form](WindowState& window) {
        window.exporting = form;
        window.dialog.is_new = false;
    });
    const bool has_list = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    if (draw_dialog_buttons(plan.replaces ? "Replace" : "Export", plan.is_good() && !has_list,
                            edits))
        start(plan, edits);
}

void draw_quit_exporting_dialog(const Scene& scene, Edits& edits) {
    const int pending = scene.lab.jobs.exports().pending();
    if (pending == 0) {
        close_dialog(edits);
        return edits.quit();
    }
    const DialogFrame frame("Quit while exporting?", 30.0f, scene, edits);
    if (!frame.is_open())
        return;
    const std::string text =
        pending == 1
            ? std::string(
                  "1 export is not finished. Afterglow quits when it is done. Cancel keeps "
                  "it open. Quit now discards the export.")
            : fmt::format(
                  "{} exports are not finished. Afterglow quits when they are done. Cancel "
                  "keeps it open. Quit now discards the exports.",
                  pending);
    ImGui::TextWrapped("%s", text.c_str());
    if (!draw_dialog_buttons("Quit now", true, edits))
        return;
    close_dialog(edits);
    edits.change([](BackgroundJobs& jobs) { jobs.exports().cancel_all(); });
    edits.quit();
}
