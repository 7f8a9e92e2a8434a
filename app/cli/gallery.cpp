#include "cli/common.h"
#include "cli/progress.h"
#include "lab/gallery/gallery_folder.h"
#include "lab/gallery/gallery_writer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <iostream>

namespace {
constexpr std::array gallery_examples{
    "afterglow gallery mine.json yours.json -o my-gallery",
    "afterglow gallery crt-geom.slangp mine.json -o my-gallery --no-pages",
};

struct GalleryArguments {
    std::vector<std::string> looks;
    std::string output;
    bool has_no_pages = false;
    bool as_json = false;
};

nlohmann::ordered_json card_json(const GallerySection& section, const GalleryCard& card) {
    nlohmann::ordered_json json{{"look", section.id},
                                {"name", card.name},
                                {"thumbnail", card.thumbnail},
                                {"page", card.page},
                                {"share_line", card.share_line}};
    if (!card.why_no_page.empty())
        json["why_no_page"] = card.why_no_page;
    return json;
}

void print_gallery_json(const std::string& folder, const WrittenGallery& written) {
    using Json = nlohmann::ordered_json;
    Json presets = Json::array();
    for (const GallerySection& section : written.sections)
        for (const GalleryCard& card : section.cards)
            presets.push_back(card_json(section, card));
    const Json json{{"folder", folder},
                    {"index", gallery_index},
                    {"files", written.files},
                    {"bytes", written.bytes},
                    {"presets", std::move(presets)}};
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void print_gallery(const std::string& folder, const WrittenGallery& written) {
    std::size_t cards = 0;
    std::size_t pages = 0;
    for (const GallerySection& section : written.sections)
        for (const GalleryCard& card : section.cards) {
            ++cards;
            pages += card.page.empty() ? 0 : 1;
        }
    std::cout << fmt::format("{}: looks: {}, presets: {}, live pages: {}, {:.1f} MB\n",
                             (std::filesystem::path(folder) / gallery_index).string(),
                             written.sections.size(), cards, pages,
                             1e-6 * static_cast<double>(written.bytes));
}

int run_gallery(const GalleryArguments& arguments, const DataFolders& data) {
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    std::optional<Progress> progress;
    const auto written =
        write_gallery({arguments.looks, arguments.output, !arguments.has_no_pages}, *library,
                      [&](int done, int all) {
                          if (!progress)
                              progress.emplace(Progress::Kind::rendering_pictures, all);
                          progress->show(done);
                      });
    progress.reset();
    if (!written)
        return report(written.error());
    warn(written->warnings);
    arguments.as_json ? print_gallery_json(arguments.output, *written)
                      : print_gallery(arguments.output, *written);
    return has_errors(written->warnings) ? exit_failure : exit_done;
}
}  // namespace

/// afterglow gallery [LOOK...] -o DIR
Command add_gallery(CommandLine& program) {
    Options options = program.add_verb(
        "gallery",
        "Write a web page of presets\n\n"
        "Writes index.html with thumbnails, values and share lines, and a live page per preset. "
        "It needs no network. Without LOOK it has all looks and presets.",
        gallery_examples);
    auto arguments = std::make_shared<GalleryArguments>();
    options.add("LOOK", arguments->looks,
                "Look (name or folder), stack (phosphor+crt), shader of another program, or preset "
                "(file, PNG or line of text)");
    options
        .add("-o,--output DIR", arguments->output,
             "Folder to write. An earlier gallery is replaced")
        .required();
    options.add_flag("--no-pages", arguments->has_no_pages, "Write no live pages, which is faster");
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders& data) { return run_gallery(*arguments, data); };
}
