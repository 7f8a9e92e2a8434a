#include "formats/markdown/html_page.h"

#include "base/file_uri.h"
#include "base/text.h"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <md4c-html.h>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view style = R"(
:root { color-scheme: light dark; }
body { margin: 0; font: 16px/1.55 "Inter", system-ui, sans-serif; background: #fff; color: #222; }
nav { position: fixed; top: 0; bottom: 0; width: 13em; padding: 1.2em; overflow: auto;
      border-right: 1px solid #8884; }
nav a { display: block; padding: .18em 0; }
nav a.here { font-weight: 600; color: inherit; }
main { margin-left: 16em; padding: 1em 2em 6em; max-width: 52em; }
h1, h2, h3 { line-height: 1.25; margin: 1.6em 0 .6em; }
a { color: #a5600f; text-decoration: none; }
a:hover { text-decoration: underline; }
table { border-collapse: collapse; margin: 1em 0; }
th, td { text-align: left; vertical-align: top; padding: .35em .8em; border-bottom: 1px solid #8884; }
code { font: .9em "DejaVu Sans Mono", monospace; background: #8882; padding: .1em .3em;
       border-radius: 3px; }
pre { background: #8882; padding: .8em 1em; overflow: auto; border-radius: 5px; }
pre code { background: none; padding: 0; }
img { max-width: 100%; }
@media (prefers-color-scheme: dark) {
  body { background: #19191a; color: #d0d0ce; }
  a { color: #e0a55a; }
}
@media (max-width: 50em) { nav { position: static; width: auto; } main { margin: 0; } }
)";

// GitHub's anchor of a heading: lower case, blanks as '-', other punctuation removed.
std::string anchor_of(std::string_view html) {
    std::string anchor;
    bool is_in_tag = false;
    bool is_in_entity = false;
    for (const char c : html) {
        if (c == '<' || c == '>') {
            is_in_tag = c == '<';
            continue;
        }
        is_in_entity = c == '&' || (is_in_entity && c != ';');
        if (is_in_tag || is_in_entity || c == ';')
            continue;
        const auto byte = static_cast<unsigned char>(c);
        if (c == ' ' || c == '-')
            anchor += '-';
        else if (std::isalnum(byte) || byte >= 0x80 || c == '_')
            anchor += static_cast<char>(std::tolower(byte));
    }
    return anchor;
}

// Adds id="..." to the headings.
std::string with_anchors(std::string_view html) {
    std::string text;
    std::map<std::string, int> used;
    std::size_t done = 0;
    for (std::size_t at = html.find("<h"); at != std::string_view::npos;
         at = html.find("<h", done)) {
        const bool is_heading = at + 3 < html.size() && html[at + 2] >= '1' &&
                                html[at + 2] <= '6' && html[at + 3] == '>';
        const std::size_t end = is_heading ? html.find("</h", at) : std::string_view::npos;
        if (end == std::string_view::npos) {
            text += html.substr(done, at + 2 - done);
            done = at + 2;
            continue;
        }
        std::string anchor = anchor_of(html.substr(at + 4, end - at - 4));
        if (const int count = used[anchor]++; count > 0)
            anchor += fmt::format("-{}", count);
        text += html.substr(done, at + 3 - done);
        text += fmt::format(" id=\"{}\"", anchor);
        done = at + 3;
    }
    text += html.substr(done);
    return text;
}

// The address of a link or picture on a page.
std::string address_of(std::string_view address, const HtmlContext& context) {
    if (address.empty() || address.front() == '#' || address.find(':') != std::string_view::npos)
        return std::string(address);
    const std::size_t hash = std::min(address.find('#'), address.size());
    const fs::path path(address.substr(0, hash));
    const std::string anchor(address.substr(hash));
    const fs::path target = (context.page.parent_path() / path).lexically_normal();
    const bool is_inside = target.empty() || *target.begin() != "..";
    if (is_inside && target.extension() == ".md")
        return fs::path(path).replace_extension(".html").string() + anchor;
    return "file://" + percent_encoded((context.docs / target).lexically_normal().string()) +
           anchor;
}

// Replaces the addresses of href="..." and src="...".
std::string with_addresses(std::string_view html, const HtmlContext& context) {
    std::string text;
    std::size_t done = 0;
    while (true) {
        const std::size_t link = html.find(" href=\"", done);
        const std::size_t picture = html.find(" src=\"", done);
        const std::size_t at = std::min(link, picture);
        if (at == std::string_view::npos)
            break;
        const std::size_t begin = html.find('"', at) + 1;
        const std::size_t end = html.find('"', begin);
        if (end == std::string_view::npos)
            break;
        text += html.substr(done, begin - done);
        text += address_of(html.substr(begin, end - begin), context);
        done = end;
    }
    text += html.substr(done);
    return text;
}

std::string navigation_of(const HtmlContext& context) {
    std::string up;
    for (const fs::path& folder : context.page.parent_path())
        up += folder.empty() ? "" : "../";
    std::string text;
    for (const HtmlLink& link : context.navigation)
        text += fmt::format("<a{} href=\"{}{}\">{}</a>\n",
                            context.page == fs::path(link.page) ? " class=\"here\"" : "", up,
                            fs::path(link.page).replace_extension(".html").string(), link.label);
    return text;
}

std::string title_of(std::string_view markdown) {
    const std::string_view first = markdown.substr(0, markdown.find('\n'));
    return std::string(trim(first.substr(std::min(first.find_first_not_of('#'), first.size()))));
}

std::string escaped(std::string_view text) {
    return replace_all(replace_all(text, "&", "&amp;"), "<", "&lt;");
}
}  // namespace

Result<std::string> html_page(std::string_view markdown, const HtmlContext& context) {
    std::string html;
    const auto append = [](const MD_CHAR* text, MD_SIZE size, void* to) {
        static_cast<std::string*>(to)->append(text, size);
    };
    if (md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html,
                MD_DIALECT_GITHUB | MD_FLAG_NOHTML, 0) != 0)
        return fail({{}, 0, "memory is exhausted"});
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<title>{} – Afterglow</title>\n<style>{}</style>\n<nav>\n{}</nav>\n<main>\n{}</main>\n"
        "</html>\n",
        escaped(title_of(markdown)), style, navigation_of(context),
        with_addresses(with_anchors(html), context));
}
