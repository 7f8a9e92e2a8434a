#include "formats/settings/remote_settings_format.h"

#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"

#include <nlohmann/json.hpp>

namespace {
constexpr FileFormat remote_file{"afterglow-remote", 1};
constexpr int max_components = 16;

nlohmann::ordered_json json_of(const MidiBinding& binding) {
    return {{"parameter", binding.goal.parameter},
            {"component", binding.goal.component},
            {"channel", binding.channel},
            {"controller", binding.controller},
            {"fine", binding.is_fine}};
}

MidiBinding read_binding(const JsonValue& value, const std::filesystem::path& file,
                         Diagnostics& problems) {
    ObjectReader reader(value, file, problems);
    MidiBinding binding;
    binding.goal.parameter = reader.text("parameter");
    binding.goal.component =
        static_cast<std::size_t>(reader.whole("component", 0, 0, max_components - 1));
    binding.channel = reader.whole("channel", 1, 1, 16);
    binding.controller = reader.whole("controller", 0, 0, 127);
    binding.is_fine = reader.boolean("fine", false);
    reader.report_unknown_keys();
    return binding;
}
}  // namespace

std::string remote_settings_to_json(const RemoteSettings& settings) {
    nlohmann::ordered_json bindings = nlohmann::ordered_json::array();
    for (const MidiBinding& binding : settings.midi)
        bindings.push_back(json_of(binding));
    return json_text({{"format", remote_file.name},
                      {"version", remote_file.newest_version},
                      {"osc", settings.listens_to_osc},
                      {"osc_port", settings.osc_port},
                      {"midi", settings.listens_to_midi},
                      {"midi_picks_up", settings.has_soft_takeover},
                      {"midi_bindings", std::move(bindings)}});
}

Result<RemoteSettings> parse_remote_settings(std::string_view text,
                                             const std::filesystem::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    RemoteSettings settings;
    if (accept_header(reader, remote_file)) {
        settings.listens_to_osc = reader.boolean("osc", settings.listens_to_osc);
        settings.osc_port = reader.whole("osc_port", settings.osc_port, 1, 65535);
        settings.listens_to_midi = reader.boolean("midi", settings.listens_to_midi);
        settings.has_soft_takeover = reader.boolean("midi_picks_up", settings.has_soft_takeover);
        if (const JsonValue* bindings = reader.find("midi_bindings");
            bindings && reader.expect(*bindings, JsonValue::Kind::array))
            for (const JsonValue& binding : bindings->children)
                settings.midi.push_back(read_binding(binding, file, problems));
        reader.report_unknown_keys();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return settings;
}
