#include "lab/golden/golden_report.h"

#include "base/text.h"
#include "formats/web/html_text.h"
#include "formats/web/packed_text.h"
#include "io/files/atomic_file.h"
#include "lab/golden/golden_page.h"
#include "lab/messages/source_lines.h"

#include <fmt/format.h>

namespace {
std::string html_lines(std::string_view text) {
    std::string escaped;
    for (const std::string_view line : split_lines(text))
        escaped += html_text(line) + '\n';
    return escaped;
}

std::string image(const std::string& png, const std::string& title) {
    const std::string source =
        png.empty() ? "" : fmt::format(" src=\"data:image/png;base64,{}\"", base64(png));
    return fmt::format("<img alt=\"{}\"{}>", html_text(title), source);
}

std::string figure(const char* kind, const std::string& png, const std::string& caption,
                   const GoldenResult& result) {
    return fmt::format("<figure class=\"{}\">{}<figcaption>{}</figcaption></figure>\n", kind,
                       image(png, caption + " of " + result.item.name), html_text(caption));
}

// The script fills in the pictures.
std::string wipe(const GoldenResult& result) {
    return fmt::format(
        "<figure class=\"wipe\" hidden><div>{0}{0}<input type=\"range\" min=\"0\" max=\"100\" "
        "step=\"1\" value=\"50\" aria-label=\"Wipe between the golden and the new picture of "
        "{1}\"></div><figcaption>Wipe: golden on the left, new on the right. Drag, or use the "
        "arrow keys.</figcaption></figure>\n",
        image({}, ""), html_text(result.item.name));
}

// Without a difference, the new picture is the golden one.
std::string pictures(const GoldenResult& result) {
    std::string text;
    if (!result.golden_png.empty())
        text += figure("golden", result.golden_png, "Golden picture", result);
    if (!result.new_png.empty() || result.difference)
        text += figure("new", result.new_png, "New picture", result);
    if (!result.difference_png.empty())
        text += figure("apart", result.difference_png,
                       fmt::format("Difference × {:.0f}", result.gain), result);
    if (result.difference)
        text += wipe(result);
    return text.empty() ? text : fmt::format("<div class=\"pictures\">\n{}</div>\n", text);
}

const char* purpose_of(GoldenStatus status) {
    switch (status) {
        case GoldenStatus::missing:
            return "Create the picture";
        case GoldenStatus::orphaned:
            return "Remove the picture";
        default:
            return "Accept the new picture";
    }
}

std::string details_of(const GoldenResult& result) {
    std::string text;
    const auto row = [&](const char* label, const std::string& value) {
        if (!value.empty())
            text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", label, value);
    };
    row("File", html_text(result.item.file.string()));
    if (result.frames > 0)
        row("Drawn", fmt::format("{} px, {} {}", dimensions_text(result.size), result.frames,
                                 result.frames == 1 ? "frame" : "frames"));
    if (result.difference)
        row("Difference", fmt::format("mean {:.3g}/255, max {:.0f}/255 at pixel ({}, {})",
                                      result.difference->mean, result.difference->largest,
                                      result.difference->largest_x, result.difference->largest_y));
    if (!result.command.empty())
        row(purpose_of(result.status), "<code>" + html_text(result.command) + "</code>");
    return "<dl>\n" + text + "</dl>\n";
}

std::string entry(const GoldenResult& result, const GoldenBounds& bounds) {
    const std::string numbers = difference_text(result, bounds);
    std::string text = fmt::format(
        "<details class=\"{0}\" id=\"{1}\"{2}>\n<summary><b>{0}</b><code>{1}</code>"
        "<span>{3}</span></summary>\n",
        name_of(result.status), html_text(result.item.name),
        result.status == GoldenStatus::equal ? "" : " open",
        html_text(result.note.empty() ? numbers : result.note));
    if (!result.problems.empty())
        text += "<pre>" + html_lines(with_source_lines(result.problems)) + "</pre>\n";
    return text + details_of(result) + pictures(result) + "</details>\n";
}

std::string head(const GoldenRequest& request, const GoldenOutcome& outcome) {
    const std::string counts = counts_text(outcome);
    std::string warnings;
    for (const Diagnostic& warning : outcome.warnings)
        warnings += "<p>Warning: " + html_text(warning.message) + "</p>\n";
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
        "<title>Golden pictures: {}</title>\n<style>{}</style>\n<h1>Golden pictures: {}</h1>\n"
        "<dl>\n<dt>Looks and presets</dt><dd>{}</dd>\n<dt>Golden pictures</dt><dd>{}</dd>\n"
        "<dt>Bounds</dt><dd>{} of the pixels may differ by more than {}</dd>\n"
        "<dt>Driver</dt><dd>{}</dd>\n</dl>\n{}"
        "<p><button value=\"open\">Open all</button><button value=\"close\">Close all</button>"
        "</p>\n",
        counts, golden_page_style(), counts, html_text(request.folder.string()),
        html_text(request.directory.string()), percent_text(outcome.bounds.percent),
        levels_text(outcome.bounds.levels), html_text(to_string(outcome.driver)), warnings);
}
}  // namespace

Result<void> save_golden_report(const GoldenRequest& request, const GoldenOutcome& outcome) {
    auto file = AtomicFile::create(golden_report_file(request));
    if (!file)
        return fail(file.error());
    if (auto written = file->write(head(request, outcome)); !written)
        return written;
    for (const GoldenResult& result : outcome.results)
        if (auto written = file->write(entry(result, outcome.bounds)); !written)
            return written;
    if (auto written =
            file->write(fmt::format("<script>{}</script>\n</html>\n", golden_page_script()));
        !written)
        return written;
    return file->finish();
}
