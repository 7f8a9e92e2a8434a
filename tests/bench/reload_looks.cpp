#include "bench/reload_looks.h"

#include "bench/article_texts.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace bench {

namespace {
// The article's passes and sizes, at 1280 x 720.
constexpr const char* article_manifest = R"({
  "format": "afterglow-look", "version": 1, "name": "The article",
  "driven_by": "signal", "output": "linear",
  "passes": [
    { "name": "beam", "draw": "points", "vertex": "beam.vert", "fragment": "beam.frag",
      "format": "rgba16f", "blend": "add",
      "set": { "point_size": 3.4, "beam_color": [0.2, 1, 0.3] } },
    { "name": "persistence", "fragment": "phosphor.frag", "format": "rgba16f",
      "inputs": { "current": "beam", "previous": "persistence@1" },
      "set": { "size": [1280, 720] } },
    { "name": "bloom_x", "fragment": "blur.frag", "scale": 0.5, "format": "rgba16f",
      "inputs": { "image": "persistence" },
      "set": { "direction": [1, 0], "size": [640, 360] } },
    { "name": "bloom_y", "fragment": "blur.frag", "scale": 0.5, "format": "rgba16f",
      "inputs": { "image": "bloom_x" },
      "set": { "direction": [0, 1], "size": [640, 360] } },
    { "name": "composite", "fragment": "composite.frag", "format": "rgba16f",
      "inputs": { "phosphor": "persistence", "bloom": "bloom_y" },
      "set": { "size": [1280, 720] } }
  ]
}
)";

void write(const fs::path& file, const std::string& text) {
    std::ofstream stream(file);
    if (!(stream << text))
        throw std::runtime_error("Can't write " + file.string());
}

void write_article(const fs::path& folder) {
    fs::create_directories(folder);
    write(folder / "look.json", article_manifest);
    write(folder / "beam.vert", texts::beam_vertex);
    write(folder / "beam.frag", texts::beam_fragment);
    write(folder / "phosphor.frag", texts::phosphor_fragment);
    write(folder / "blur.frag", texts::blur_fragment);
    write(folder / "composite.frag",
          std::string(texts::composite_head) + texts::glass + texts::composite_literal);
}
}  // namespace

const std::vector<ReloadLook>& reload_looks() {
    static const std::vector<ReloadLook> looks{
        {"reload-article", "the article's composite at 1280 x 720", "article", "bloom_intensity",
         "    light *= ", "1.5;"},
        {"reload", "Phosphor's composite at 1280 x 720", "phosphor", "exposure",
         "    vec3 light = ", "through_glass(fringed, place);"}};
    return looks;
}

void write_reload_looks(const fs::path& folder) {
    fs::copy(fs::path(AFTERGLOW_SOURCE_DIR) / "shaders", folder, fs::copy_options::recursive);
    write_article(folder / "article");
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string with_factor(std::string text, const ReloadLook& look, int number) {
    const std::string line = look.before + look.after;
    const auto at = text.find(line);
    if (at == std::string::npos)
        throw std::runtime_error("composite.frag doesn't contain the line that this bench edits");
    return text.replace(at, line.size(),
                        fmt::format("{}{:.7f} * {}", look.before, 1.0 + 1e-6 * number, look.after));
}

std::string edited_line(const std::string& text, const ReloadLook& look) {
    const auto at = text.find(look.before);
    return text.substr(at, text.find('\n', at) - at);
}

}  // namespace bench
