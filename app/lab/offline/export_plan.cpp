#include "lab/offline/export_plan.h"

#include "base/text.h"
#include "formats/cues/cue_sheet.h"
#include "lab/document/output_name.h"
#include "lab/offline/export_output.h"
#include "lab/offline/output_precision.h"
#include "lab/rendering/named_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace fs = std::filesystem;

std::string ExportPlan::problem_of(ExportField field) const {
    const auto found = std::ranges::find(problems, field, &FieldProblem::field);
    return found == problems.end() ? "" : found->text;
}

namespace {
/// Reads the fields of a form one by one, and collects their problems.
class FormReader {
public:
    explicit FormReader(ExportPlan& plan) : m_plan(plan) {}

    void refuse(ExportField field, std::string text) {
        m_plan.problems.push_back({field, std::move(text)});
    }

    /// A number within its limits; `otherwise` for an empty text or a problem.
    double number(ExportField field, const std::string& text, const Limit& limit,
                  double otherwise) {
        return read(field, text, limit, otherwise, {parse_number, "a number", ""});
    }
    /// A time as seconds or M:SS.
    double seconds(ExportField field, const std::string& text, const Limit& limit,
                   double otherwise) {
        return read(field, text, limit, otherwise, {parse_cue_time, "seconds or M:SS", " s"});
    }

private:
    struct Form {
        std::optional<double> (*parse)(std::string_view text);
        const char* name;
        const char* unit;
    };
    double read(ExportField field, const std::string& text, const Limit& limit, double otherwise,
                const Form& form) {
        if (trim(text).empty())
            return otherwise;
        const auto typed = form.parse(trim(text));
        if (typed && *typed >= limit.low && *typed <= limit.high)
            return *typed;
        refuse(field, fmt::format("Type {} from {}{} to {}{}.", form.name, format_number(limit.low),
                                  form.unit, format_number(limit.high), form.unit));
        return otherwise;
    }

    ExportPlan& m_plan;
};

// The field that a refused choice belongs to: the first that is refused alone.
ExportField field_of(const fs::path& file, const FilmChoice& choice) {
    const auto is_refused = [&](const FilmChoice& part) { return !film_encoding(file, part); };
    if (is_refused({}))
        return ExportField::file;
    if (is_refused({.codec = choice.codec}))
        return ExportField::codec;
    if (is_refused({.sound = choice.sound}))
        return ExportField::sound;
    if (is_refused({.codec = choice.codec, .keeps_alpha = choice.keeps_alpha}))
        return ExportField::alpha;
    if (is_refused({.codec = choice.codec, .keeps_alpha = choice.keeps_alpha, .hdr = choice.hdr}))
        return ExportField::hdr;
    return ExportField::quality;
}

std::string as_sentence(std::string text) {
    if (!text.empty())
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    if (!text.ends_with('.'))
        text += '.';
    return text;
}

FilmChoice read_film(const ExportForm& form, FormReader& reader) {
    FilmChoice choice{.codec = form.codec, .sound = form.sound, .keeps_alpha = form.keeps_alpha};
    if (!trim(form.quality).empty())
        choice.quality = reader.number(ExportField::quality, form.quality, {1.0, 100.0}, 0.0);
    if (choice.quality == 0.0)
        choice.quality.reset();
    if (form.hdr == 0 || !is_film_name(typed_file(form.file, form.folder)))
        return choice;
    const HdrLight usual;
    const HdrLight light{
        reader.number(ExportField::hdr, form.paper_white,
                      {hdr_paper_whites[0], hdr_paper_whites[1]}, usual.paper_white),
        reader.number(ExportField::hdr, form.peak, {hdr_peaks[0], hdr_peaks[1]}, usual.peak)};
    if (light.peak < light.paper_white)
        reader.refuse(ExportField::hdr, "The peak must not be below paper white.");
    choice.hdr = FilmHdr{form.hdr == 1 ? HdrTransfer::pq : HdrTransfer::hlg, light};
    return choice;
}

void check_film(ExportPlan& plan, const ExportFacts& facts, FormReader& reader) {
    const ExportSettings& settings = plan.settings;
    const auto encoding = film_encoding(settings.file, settings.film);
    if (!encoding)
        return reader.refuse(field_of(settings.file, settings.film),
                             as_sentence(encoding.error().front().message));
    const Extent size = settings.size.is_empty() ? facts.render_size : settings.size;
    if (const auto fits = check_film_extent(*encoding, size); !fits)
        reader.refuse(ExportField::size, as_sentence(fits.error().front().message));
    if (facts.sound_seconds > 0.0)
        plan.note = lossy_sound_warning(*encoding, facts.signal);
}

constexpr const char* another_export = "Another export is writing this file. Choose another name.";

void check_file(const ExportForm& form, ExportPlan& plan, const ExportFacts& facts,
                FormReader& reader) {
    const fs::path& file = plan.settings.file;
    if (trim(form.file).empty())
        return reader.refuse(ExportField::file, "Type a file name.");
    if (is_film_output(file.string()))
        check_film(plan, facts, reader);
    if (!plan.is_good())
        return;
    if (facts.queue.is_target(file))
        return reader.refuse(ExportField::file, another_export);
    if (const auto good = check_export(facts.document, plan.settings); !good)
        return reader.refuse(ExportField::file, as_sentence(good.error().front().message));
    const auto names = parse_frame_names(file.string());
    plan.replaces = names && names->exist();
}

Extent read_size(const ExportForm& form, FormReader& reader) {
    if (form.size.empty())
        return {};
    if (const auto extent = parse_extent(form.size))
        return *extent;
    reader.refuse(ExportField::size, "Type a size such as 1280x720, up to 16384 px per side.");
    return {};
}

// The number of frames and how long drawing takes, if both are known.
void estimate(ExportPlan& plan, const ExportFacts& facts) {
    const ExportSettings& settings = plan.settings;
    if (settings.loops && settings.seconds <= 0.0)
        return;
    const bool is_as_long_as_video =
        settings.seconds <= 0.0 && facts.sound_seconds <= 0.0 && facts.draws_video();
    if (is_as_long_as_video)  // the length is read when the export starts
        return;
    const double rest = facts.sound_seconds > 0.0 ? facts.sound_seconds - settings.start
                                                  : film_seconds_without_sound;
    const double seconds = settings.seconds > 0.0 ? settings.seconds : rest;
    if (seconds <= 0.0)
        return;
    plan.frames = part_of(settings.start, seconds, settings.fps).count();
    const Extent size = settings.size.is_empty() ? facts.render_size : settings.size;
    const auto pixels = [](Extent extent) {
        return static_cast<double>(extent.width) * static_cast<double>(extent.height);
    };
    if (facts.render_size.is_empty())
        return;
    const double per_frame =
        1e-3 * facts.frame_milliseconds * pixels(size) / pixels(facts.render_size);
    plan.work_seconds =
        per_frame * (static_cast<double>(plan.frames) + settings.start * settings.fps);
}
}  // namespace

ExportPlan planned_export(const ExportForm& form, const ExportFacts& facts) {
    constexpr double longest = 86400.0;
    ExportPlan plan;
    FormReader reader(plan);
    plan.settings.file = typed_file(form.file, form.folder);
    plan.settings.size = read_size(form, reader);
    plan.settings.fps = reader.number(ExportField::fps, form.fps, {1.0, 1000.0}, 60.0);
    plan.settings.loops = form.loops;
    if (!form.loops)
        plan.settings.start = reader.seconds(ExportField::start, form.start, {0.0, longest}, 0.0);
    plan.settings.seconds = reader.seconds(ExportField::length, form.length, {0.001, longest}, 0.0);
    plan.settings.film = read_film(form, reader);
    plan.settings.draws_subframes = form.has_subframes && facts.has_subframes() && !form.loops;
    if (!form.loops && facts.sound_seconds > 0.0 && plan.settings.seconds <= 0.0 &&
        plan.settings.start >= facts.sound_seconds)
        reader.refuse(
            ExportField::start,
            fmt::format("The sound ends at {:.4g} s. Type an earlier start.", facts.sound_seconds));
    if (form.loops && facts.plays_cues)
        reader.refuse(ExportField::length, "Cues don't repeat. Turn off Play cues first.");
    check_file(form, plan, facts, reader);
    estimate(plan, facts);
    return plan;
}

const std::vector<std::string>& hdr_choices() {
    static const std::vector<std::string> choices{"None", "HDR10", "HLG"};
    return choices;
}

const std::vector<ExportKind>& export_kinds() {
    static const std::vector<ExportKind> kinds{
        {"MP4", ".mp4"},
        {"MOV", ".mov"},
        {"MKV", ".mkv"},
        {"WebM", ".webm"},
        {"GIF", ".gif"},
        {"PNG sequence", "_%04d.png"},
        {"EXR sequence", "_%04d.exr"},
    };
    return kinds;
}

std::optional<std::size_t> export_kind_of(const std::string& name) {
    const std::string ending = to_lower(fs::path(name).extension().string());
    for (std::size_t i = 0; i < export_kinds().size(); ++i)
        if (fs::path("x" + export_kinds()[i].ending).extension() == ending)
            return i;
    return std::nullopt;
}

std::string with_export_kind(const std::string& name, const ExportKind& kind) {
    std::string stem = export_kind_of(name) ? fs::path(name).replace_extension().string() : name;
    if (const std::size_t number = stem.rfind("_%"); number != std::string::npos)
        stem.resize(number);
    return stem + kind.ending;
}

namespace {
template <class Row>
std::vector<ExportChoice> choices_of(const std::vector<const Row*>& rows, const Row* usual) {
    std::vector<ExportChoice> choices;
    if (rows.empty() || !usual)
        return choices;
    choices.push_back({"", fmt::format("Default: {}", usual->label)});
    for (const Row* row : rows)
        choices.push_back({row->name, row->label});
    return choices;
}
}  // namespace

std::vector<ExportChoice> codec_choices(const fs::path& file, const FilmChoice& choice) {
    auto encoding = film_encoding(file, {.keeps_alpha = choice.keeps_alpha, .hdr = choice.hdr});
    if (!encoding)
        encoding = film_encoding(file, {});
    const auto codecs = codecs_for(file);
    if (codecs.size() < 2)
        return {};
    return choices_of(codecs, encoding ? encoding->codec : nullptr);
}

std::vector<ExportChoice> sound_choices(const fs::path& file) {
    const auto encoding = film_encoding(file, {});
    auto choices = choices_of(sound_codecs_for(file), encoding ? encoding->sound : nullptr);
    if (!choices.empty())
        choices.push_back({no_sound, "None"});
    return choices;
}

std::string quality_hint(const ExportSettings& settings) {
    FilmChoice choice = settings.film;
    choice.quality.reset();
    const auto encoding = film_encoding(settings.file, choice);
    if (!encoding || encoding->codec->quality.option.empty())
        return {};
    const FilmQuality& quality = encoding->codec->quality;
    return fmt::format("{} ({}: {} best, {} smallest)", quality.usual, quality.measure,
                       quality.best, quality.worst);
}

ExportForm initial_export_form(ExportForm last, const ExportFacts& facts, const Date& date) {
    const auto kind = export_kind_of(last.file);
    const bool is_lossless = facts.sound_seconds > 0.0 && is_drawn_as_xy(facts.signal);
    std::string ending = kind ? export_kinds()[*kind].ending : ".mp4";
    if (ending == ".mp4" && is_lossless)
        ending = ".mov";
    if (const fs::path typed(last.file); typed.has_parent_path())
        last.folder = typed_file(last.file, last.folder).parent_path();
    last.folder = usual_folder(last.folder);
    last.file = unused_name(last.folder, output_stem(facts.document, date), ending,
                            [&](const fs::path& file) { return facts.queue.is_target(file); });
    if (last.fps.empty())
        last.fps = "60";
    return last;
}

const std::vector<std::string>& still_sizes() {
    static const std::vector<std::string> sizes{"1x", "2x", "4x", "1080p", "2160p"};
    return sizes;
}

Extent still_extent(const std::string& size, Extent render_size) {
    if (const auto extent = parse_extent(size))
        return *extent;
    const int times = size == "2x" ? 2 : size == "4x" ? 4 : 1;
    return {render_size.width * times, render_size.height * times};
}

std::string still_note(const StillForm& form, const Look& look) {
    if (form.size != "1x")
        return "Rendered in the background at the current time.";
    const StillFormat& format = still_formats()[static_cast<std::size_t>(form.format)];
    if (has_few_bits(look) &&
        is_deep_still({.file = "picture" + format.ending, .png_bits = format.bits}))
        return "The displayed picture has 8 bits. Other sizes are drawn with more.";
    return "";
}

Result<StillSettings> planned_still(const StillForm& form, Extent render_size, double seconds,
                                    const IsTaken& is_taken) {
    if (trim(form.file).empty())
        return fail({{}, 0, "Type a file name."});
    const auto& format = still_formats()[static_cast<std::size_t>(form.format)];
    StillSettings settings{.file = typed_file(form.file, form.folder),
                           .png_bits = format.bits,
                           .size = still_extent(form.size, render_size),
                           .seconds = seconds};
    if (settings.file.extension().empty())
        settings.file += format.ending;
    if (is_taken(settings.file))
        return fail({{}, 0, another_export});
    constexpr int largest = 16384;
    if (settings.size.width > largest || settings.size.height > largest)
        return fail({{},
                     0,
                     fmt::format("{} × {} px is too large. The limit is {} px per side.",
                                 settings.size.width, settings.size.height, largest)});
    if (const auto good = check_still(settings.file); !good)
        return fail({{}, 0, as_sentence(good.error().front().message)});
    return settings;
}

StillForm initial_still_form(StillForm last, const Document& document, const Date& date,
                             const IsTaken& is_taken) {
    if (const fs::path typed(last.file); typed.has_parent_path())
        last.folder = typed_file(last.file, last.folder).parent_path();
    last.folder = usual_folder(last.folder);
    const auto& format = still_formats()[static_cast<std::size_t>(last.format)];
    last.file = unused_name(last.folder, output_stem(document, date), format.ending, is_taken);
    return last;
}
