#include "formats/settings/remote_settings_format.h"

#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"

#include <nlohmann/json.hpp>

namespace {
constexpr FileFormat remote_file{"afterglow-remote", 1};
constexpr int max_components = 16;
constexpr int max_port = 65535;

const Choices<NetworkReach>& reaches() {
    static const Choices<NetworkReach> choices{{"this machine", NetworkReach::this_machine},
                                               {"local network", NetworkReach::local_network}};
    return choices;
}

const Choices<MidiTrigger::Kind>& trigger_kinds() {
    static const Choices<MidiTrigger::Kind> choices{{"note", MidiTrigger::Kind::note},
                                                    {"program", MidiTrigger::Kind::program},
                                                    {"control", MidiTrigger::Kind::control}};
    return choices;
}

template <class T>
std::string_view name_in(const Choices<T>& choices, T chosen) {
    for (const auto& [name, value] : choices)
        if (value == chosen)
            return name;
    return {};
}

nlohmann::ordered_json json_of(const MidiBinding& binding) {
    return {{"parameter", binding.goal.parameter},
            {"component", binding.goal.component},
            {"channel", binding.channel},
            {"controller", binding.controller},
            {"fine", binding.is_fine}};
}

nlohmann::ordered_json json_of(const MidiCommand& command) {
    return {{"command", command.command},
            {"trigger", name_in(trigger_kinds(), command.trigger.kind)},
            {"channel", command.trigger.channel},
            {"number", command.trigger.number}};
}

template <class T>
nlohmann::ordered_json list_of(const std::vector<T>& items) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const T& item : items)
        list.push_back(json_of(item));
    return list;
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

MidiCommand read_command(const JsonValue& value, const std::filesystem::path& file,
                         Diagnostics& problems) {
    ObjectReader reader(value, file, problems);
    MidiCommand command;
    command.command = reader.text("command");
    command.trigger.kind = reader.choice("trigger", trigger_kinds(), MidiTrigger::Kind::note);
    command.trigger.channel = reader.whole("channel", 1, 1, 16);
    command.trigger.number = reader.whole("number", 0, 0, 127);
    reader.report_unknown_keys();
    return command;
}

template <class T>
void read_list(ObjectReader& reader, const char* key,
               T (*read)(const JsonValue&, const std::filesystem::path&, Diagnostics&),
               std::vector<T>& items) {
    const JsonValue* list = reader.find(key);
    if (!list || !reader.expect(*list, JsonValue::Kind::array))
        return;
    for (const JsonValue& item : list->children)
        items.push_back(read(item, reader.file(), reader.problems()));
}
}  // namespace

std::string remote_settings_to_json(const RemoteSettings& settings) {
    return json_text({{"format", remote_file.name},
                      {"version", remote_file.newest_version},
                      {"osc", settings.listens_to_osc},
                      {"osc_port", settings.osc_port},
                      {"osc_from", name_in(reaches(), settings.osc_reach)},
                      {"osc_reply_port", settings.osc_reply_port},
                      {"midi", settings.listens_to_midi},
                      {"midi_picks_up", settings.has_soft_takeover},
                      {"midi_bindings", list_of(settings.midi)},
                      {"midi_commands", list_of(settings.midi_commands)}});
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
        settings.osc_port = reader.whole("osc_port", settings.osc_port, 1, max_port);
        settings.osc_reach = reader.choice("osc_from", reaches(), settings.osc_reach);
        settings.osc_reply_port =
            reader.whole("osc_reply_port", settings.osc_reply_port, 0, max_port);
        settings.listens_to_midi = reader.boolean("midi", settings.listens_to_midi);
        settings.has_soft_takeover = reader.boolean("midi_picks_up", settings.has_soft_takeover);
        read_list(reader, "midi_bindings", read_binding, settings.midi);
        read_list(reader, "midi_commands", read_command, settings.midi_commands);
        reader.report_unknown_keys();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return settings;
}
