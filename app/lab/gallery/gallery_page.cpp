#include "lab/gallery/gallery_page.h"

#include "base/file_uri.h"
#include "base/text.h"
#include "formats/web/html_text.h"
#include "lab/gallery/gallery_style.h"

#include <fmt/format.h>

namespace {
constexpr std::string_view page_start =
    "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
    "<meta name=\"generator\" content=\"Afterglow gallery\">\n";

// Descriptions may have several lines.
std::string html_lines_of(const std::string& text) {
    std::string lines;
    for (const std::string_view line : split_lines(text))
        lines += (lines.empty() ? "" : "<br>") + html_text(replace_all(line, "\t", " "));
    return lines;
}

// An element with a text; "" without one.
std::string element(const char* tag, const char* kind, const std::string& text) {
    return text.empty()
               ? std::string()
               : fmt::format("<{0} class=\"{1}\">{2}</{0}>\n", tag, kind, html_lines_of(text));
}

std::string link_to(const std::string& path) {
    return '"' + percent_encoded(path) + '"';
}

std::string swatch(const std::string& color) {
    return color.empty() ? color : fmt::format("<i style=\"background:{}\"></i>", html_text(color));
}

std::string value_row(const GalleryValue& value) {
    return fmt::format("<dt>{}</dt><dd>{}{}{}</dd>\n", html_text(value.label), swatch(value.color),
                       html_text(value.text), element("small", "modulation", value.modulation));
}

// The beginning of the list, in one paragraph.
std::string preview_of(const std::vector<GalleryValue>& values) {
    constexpr std::size_t enough = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(values.size(), enough); ++i)
        text += fmt::format("{}{} {}", i == 0 ? "" : ", ", values[i].label, values[i].text);
    return values.size() > enough ? text + ", …" : text;
}

std::string values_of(const std::vector<GalleryValue>& values) {
    if (values.empty())
        return {};
    std::string text = fmt::format(
        "<details><summary><b>{} {}</b> <span>{}</span></summary>\n<dl>\n", values.size(),
        values.size() == 1 ? "value" : "values", html_text(preview_of(values)));
    std::string heading;
    for (const GalleryValue& value : values) {
        if (value.heading != heading)
            text += element("dt", "heading", value.heading);
        heading = value.heading;
        text += value_row(value);
    }
    return text + "</dl></details>\n";
}

std::string facts_of(const std::vector<GalleryFact>& facts) {
    std::string text;
    for (const GalleryFact& fact : facts)
        text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", html_text(fact.label),
                            replace_all(html_text(fact.text), ",", ",<wbr>"));
    return text.empty() ? text : "<dl class=\"facts\">\n" + text + "</dl>\n";
}

std::string thumbnail_of(const GalleryCard& card) {
    const std::string image =
        fmt::format("<img src={} alt=\"{}\" width=\"480\" height=\"270\" loading=\"lazy\">",
                    link_to(card.thumbnail), html_text(card.name));
    return card.page.empty() ? fmt::format("<div class=\"picture\">{}</div>\n", image)
                             : fmt::format(
                                   "<a class=\"picture\" href={} title=\"Open the live page\">{}"
                                   "<span>Live</span></a>\n",
                                   link_to(card.page), image);
}

std::string card_of(const GalleryCard& card) {
    std::string text = "<article>\n" + thumbnail_of(card);
    text += element("h3", "name", card.name);
    text += element("p", "author", card.author.empty() ? "" : "by " + card.author);
    text += element("p", "about", card.about);
    text += facts_of(card.facts);
    text += values_of(card.values);
    text +=
        element("p", "note", card.why_no_page.empty() ? "" : "No live page: " + card.why_no_page);
    return text + fmt::format(
                      "<div class=\"share\"><input readonly value=\"{}\" aria-label=\"Share line "
                      "of {}\"><button>Copy</button></div>\n</article>\n",
                      html_text(card.share_line), html_text(card.name));
}

std::string credits_of(const GallerySection& section) {
    std::string text = section.author.empty() ? "" : "by " + section.author;
    if (!section.license.empty())
        text += (text.empty() ? "Licence: " : " · Licence: ") + section.license;
    return text;
}

std::string section_of(const GallerySection& section) {
    std::string text =
        fmt::format("<section id=\"{}\">\n<h2>{} <code>{}</code></h2>\n", html_text(section.anchor),
                    html_text(section.name), html_text(section.id));
    text += element("p", "about", section.about);
    text += element("p", "credits", credits_of(section));
    text += "<div class=\"cards\">\n";
    for (const GalleryCard& card : section.cards)
        text += card_of(card);
    return text + "</div>\n</section>\n";
}

std::string navigation_of(const std::vector<GallerySection>& sections) {
    std::string text;
    for (const GallerySection& section : sections)
        text += fmt::format("<a href=\"#{}\">{} <small>{}</small></a>\n",
                            percent_encoded(section.anchor), html_text(section.name),
                            section.cards.size());
    return sections.size() < 2 ? std::string() : "<nav aria-label=\"Looks\">\n" + text + "</nav>\n";
}

std::string count_text(const std::vector<GallerySection>& sections) {
    std::size_t cards = 0;
    for (const GallerySection& section : sections)
        cards += section.cards.size();
    return fmt::format("{} {}", cards, cards == 1 ? "preset" : "presets");
}

std::string head_of(const std::vector<GallerySection>& sections) {
    return fmt::format(
        "{}<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' "
        "file:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
        "<title>Afterglow gallery</title>\n<style>{}</style>\n<header>\n<h1>Afterglow "
        "gallery</h1>\n"
        "<input type=\"search\" placeholder=\"Search presets\" aria-label=\"Search names, looks "
        "and descriptions\" hidden>\n<output>{}</output>\n</header>\n",
        page_start, gallery_style(), count_text(sections));
}
}  // namespace

std::string gallery_page(const std::vector<GallerySection>& sections) {
    std::string text = head_of(sections) + navigation_of(sections) + "<main>\n";
    for (const GallerySection& section : sections)
        text += section_of(section);
    return text + fmt::format(
                      "<p class=\"none\" hidden>No presets match. <button>Clear search</button>"
                      "</p>\n</main>\n<script>{}</script>\n</html>\n",
                      gallery_script());
}

bool is_gallery_page(std::string_view html) {
    return html.starts_with(page_start);
}

bool has_gallery_link(std::string_view html, const std::string& path) {
    return html.find('=' + link_to(path)) != html.npos;
}
