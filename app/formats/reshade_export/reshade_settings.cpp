#include "formats/reshade_export/reshade_settings.h"

#include <fmt/format.h>

namespace {
std::string path_text(const std::filesystem::path& path) {
    return "\"" + path.generic_string() + "\"";
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = ' ';
    return text;
}
}  // namespace

std::string reshade_preset(const ReshadeNames& names, const std::vector<FxControl>& controls) {
    std::string text = fmt::format(
        "PreprocessorDefinitions=\nTechniques={0}@{1}\n"
        "TechniqueSorting={0}@{1}\n\n[{1}]\n",
        names.technique, names.file);
    for (const FxControl& control : controls)
        text += fmt::format("{}={}\n", control.control.id, fx_preset_value(control));
    return text;
}

std::string vkbasalt_settings(const ReshadeNames& names, const std::vector<FxControl>& controls) {
    std::string text = fmt::format(
        "# The settings of vkBasalt for one effect. Change the paths if you move the files.\n"
        "effects = {0}\n{0} = {1}\nreshadeTexturePath = {2}\nreshadeIncludePath = {2}\n"
        "toggleKey = Home\nenableOnLaunch = True\n\n",
        names.technique, path_text(names.folder / names.file), path_text(names.folder));
    for (const FxControl& control : controls) {
        const std::string value = fx_setting_value(control);
        const std::string label = one_line(control.control.label);
        text += value.empty()
                    ? fmt::format("# {}: set {} in the effect, because vkBasalt has no vectors\n",
                                  label, control.control.id)
                    : fmt::format("# {}\n{} = {}\n", label, control.control.id, value);
    }
    return text;
}
