#include "lab/match/match_report.h"

#include "formats/web/html_text.h"
#include "formats/web/packed_text.h"
#include "io/files/atomic_file.h"
#include "io/pictures/png_encoder.h"
#include "model/picture/difference.h"

#include <fmt/format.h>

namespace {
constexpr double gain = 4.0F;  // of the difference

constexpr const char* style =
    "body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:72em;padding:0 1em;"
    "background:#16181c;color:#d8dce2}h1{font-size:1.3em}figure{margin:0}"
    "div{display:grid;grid-template-columns:repeat(auto-fit,minmax(20em,1fr));gap:1em}"
    "img{width:100%;image-rendering:pixelated}figcaption,td.why{color:#9aa3ae}"
    "table{border-collapse:collapse;margin:1.5em 0}td,th{padding:.2em 1.2em .2em 0;"
    "text-align:right}td:first-child,th:first-child,td.why{text-align:left}";

Result<std::string> figure(const Picture& picture, const std::string& caption) {
    const auto png = encode_png(picture);
    if (!png)
        return fail(png.error());
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption>"
        "</figure>\n",
        html_text(caption), base64(*png));
}

std::string row(const FoundNumber& number, const Look& look) {
    return fmt::format(
        "<tr><td>{}</td><td>{:.4g}</td><td>{:.4g}</td><td>{:.4g}</td>"
        "<td class=\"why\">{}</td></tr>\n",
        html_text(found_label(number, look)), number.value, number.low, number.high,
        number.why_not.empty() ? "" : "Not identifiable: " + html_text(number.why_not));
}

std::string table(const MatchedFile& matched) {
    std::string text;
    for (const auto& [parameter, label] : matched.result.types)
        text += fmt::format("<p>{}: {}</p>\n", html_text(parameter), html_text(label));
    text += "<table><tr><th>Parameter</th><th>Value</th><th>From</th><th>To</th><th></th></tr>\n";
    for (const FoundNumber& number : matched.result.matched.numbers)
        text += row(number, matched.document.look());
    return text + "</table>\n<p>From and To: 90 % interval.</p>\n";
}
}  // namespace

std::string found_label(const FoundNumber& number, const Look& look) {
    for (const Parameter& parameter : look.parameters)
        if (parameter.name == number.parameter && parameter.type.size() > 1)
            return fmt::format("{} {}", number.parameter,
                               component_label(parameter, number.component));
    return number.parameter;
}

Result<void> write_match_report(const MatchedFile& matched, const std::filesystem::path& photo,
                                const std::filesystem::path& file) {
    const MatchJobResult& result = matched.result;
    std::string figures;
    for (const auto& [picture, caption] :
         {std::pair{result.pictures.photo, std::string("Photo, straightened")},
          std::pair{result.pictures.seen, std::string("Look, as the camera would see it")},
          std::pair{difference_picture(result.pictures.photo, result.pictures.seen, gain),
                    fmt::format("Difference × {:g}", gain)}}) {
        auto made = figure(picture, caption);
        if (!made)
            return fail(made.error());
        figures += *made;
    }
    const std::string title =
        fmt::format("{} matched to {}", matched.document.look().name, photo.filename().string());
    return write_atomically(
        file,
        fmt::format("<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                    "img-src data:; style-src 'unsafe-inline'\">\n"
                    "<title>{0}</title>\n<style>{1}</style>\n<h1>{0}</h1>\n<div>\n{2}</div>\n"
                    "{3}<p>{8} Difference: {4:.2f} % of white (RMS). {5} pictures of {6} x {7} px "
                    "were drawn.</p>\n</html>\n",
                    html_text(title), style, figures, table(matched),
                    100.0 * result.matched.residual, result.matched.pictures, result.size.width,
                    result.size.height, html_text(explained_text(result.matched))));
}
