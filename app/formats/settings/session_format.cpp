#include "formats/settings/session_format.h"

#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"
#include "formats/preset/preset_format.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>

namespace {
constexpr FileFormat session_file{"afterglow-session", 1};
constexpr std::size_t max_steps = 200;

const Choices<Filter> filters{{"nearest", Filter::nearest}, {"linear", Filter::linear}};

nlohmann::ordered_json json_of(const PassOverrides& overrides) {
    nlohmann::ordered_json document = nlohmann::ordered_json::object();
    for (const auto& [pass, override] : overrides) {
        nlohmann::ordered_json& entry = document[pass] = nlohmann::ordered_json::object();
        if (override.format)
            entry["format"] = info_of(*override.format).name;
        if (override.scale)
            entry["scale"] = *override.scale;
        if (override.filter)
            entry["filter"] = *override.filter == Filter::nearest ? "nearest" : "linear";
    }
    return document;
}

nlohmann::ordered_json json_of(const SessionState& state) {
    nlohmann::ordered_json json{{"step", state.step},
                                {"preset", preset_json(state.preset, nullptr, Digits::all)},
                                {"overrides", json_of(state.overrides)}};
    if (state.is_picture_driven)
        json["picture_driven"] = true;
    if (state.locks.signal)
        json["keeps_signal"] = true;
    if (state.locks.source)
        json["keeps_source"] = true;
    if (state.chose_content)
        json["chose_content"] = true;
    if (state.opened > 0)
        json["opened"] = state.opened;
    if (!state.cues.file.empty())
        json["cue_file"] = state.cues.file;
    if (!state.cues.text.empty())
        json["cues"] = state.cues.text;
    return json;
}

// Most states have the cues of the current one, which are written only once.
nlohmann::ordered_json json_of(const SessionState& state, const CueText& current) {
    nlohmann::ordered_json json = json_of(state);
    if (!current.is_empty() && state.cues == current) {
        json.erase("cue_file");
        json.erase("cues");
        json["has_current_cues"] = true;
    }
    return json;
}

nlohmann::ordered_json json_of(std::span<const SessionState> states, const CueText& current) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SessionState& state : states)
        list.push_back(json_of(state, current));
    return list;
}

// A preset without a look can't be read. It is the state of a session in which no look was opened.
void add_state(nlohmann::ordered_json& json, const char* key, const SessionState& state,
               const CueText& current) {
    if (!state.preset.look.empty())
        json[key] = json_of(state, current);
}

// Without the first one, which has keys of its own in the session.
nlohmann::ordered_json json_of(std::span<const SessionPreset> opened, const CueText& current) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SessionPreset& preset : opened.subspan(1)) {
        list.push_back({{"preset_file", preset.file}});
        add_state(list.back(), "saved", preset.saved, current);
    }
    return list;
}

// The number of steps to keep, counted from `begin`: a session that is too large could not be read.
template <class Iterator>
std::size_t kept_steps(Iterator begin, Iterator end, const CueText& current) {
    constexpr std::size_t most_cue_bytes = std::size_t{1} << 20;
    std::size_t bytes = 0;
    std::size_t count = 0;
    for (; begin != end && count < max_steps; ++begin, ++count) {
        if (begin->cues != current)
            bytes += begin->cues.text.size();
        if (bytes > most_cue_bytes)
            break;
    }
    return count;
}

nlohmann::ordered_json json_of(const ParameterSetting& setting) {
    nlohmann::ordered_json entry = nlohmann::ordered_json::object();
    if (setting.is_favourite)
        entry["favourite"] = true;
    if (setting.is_locked)
        entry["locked"] = true;
    if (setting.ends) {
        entry["low"] = setting.ends->low;
        entry["high"] = setting.ends->high;
    }
    return entry;
}

const Choices<CompareMode> modes{{"off", CompareMode::off},
                                 {"wipe", CompareMode::wipe},
                                 {"side by side", CompareMode::side_by_side},
                                 {"difference", CompareMode::difference}};

const Choices<DifferenceMeasure> measures{{"absolute", DifferenceMeasure::absolute},
                                          {"relative", DifferenceMeasure::relative},
                                          {"squared", DifferenceMeasure::squared}};

const Choices<Other> other_names{{"article", {}},
                                 {"file", {Other::Kind::file}},
                                 {"A", {Other::Kind::slot, 0}},
                                 {"B", {Other::Kind::slot, 1}},
                                 {"C", {Other::Kind::slot, 2}}};

template <class T>
std::string_view name_or_first(const Choices<T>& choices, const T& chosen) {
    const auto found =
        std::ranges::find(choices, chosen, [](const auto& each) { return each.second; });
    return found == choices.end() ? choices.front().first : found->first;
}

nlohmann::ordered_json json_of(const Comparison& comparison) {
    Other other = comparison.other;
    other.file.clear();
    return {{"mode", name_or_first(modes, comparison.mode)},
            {"with", name_or_first(other_names, other)},
            {"file", comparison.other.file.string()},
            {"measure", name_or_first(measures, comparison.measure)},
            {"gain", comparison.gain_stops},
            {"equal_brightness", comparison.has_equal_brightness}};
}

// Each slot as a preset, by its name.
nlohmann::ordered_json json_of(const LookSlots& looks) {
    nlohmann::ordered_json document = nlohmann::ordered_json::object();
    for (const auto& [look, slots] : looks)
        for (std::size_t i = 0; i < slots.size(); ++i)
            if (slots[i]) {
                Preset preset;
                preset.look = look;
                preset.name = slots[i]->preset;
                preset.values = slots[i]->values;
                document[look][slot_name(i)] = preset_json(preset, nullptr, Digits::all);
            }
    return document;
}

nlohmann::ordered_json json_of(const LookParameterSettings& looks) {
    nlohmann::ordered_json document = nlohmann::ordered_json::object();
    for (const auto& [look, settings] : looks)
        for (const auto& [name, setting] : settings)
            document[look][name] = json_of(setting);
    return document;
}

ParameterSetting read_parameter_setting(const JsonValue& value, const std::filesystem::path& file,
                                        Diagnostics& problems) {
    ObjectReader reader(value, file, problems);
    ParameterSetting setting;
    setting.is_favourite = reader.boolean("favourite", false);
    setting.is_locked = reader.boolean("locked", false);
    if (reader.find("low")) {
        reader.require("high");
        setting.ends = Limit{reader.number("low", 0.0), reader.number("high", 0.0)};
    }
    reader.report_unknown_keys();
    return setting;
}

Comparison read_comparison(const JsonValue& value, const std::filesystem::path& file,
                           Diagnostics& problems) {
    constexpr double max_stops = 16.0;
    ObjectReader reader(value, file, problems);
    Comparison comparison;
    comparison.mode = reader.choice("mode", modes, comparison.mode);
    comparison.other = reader.choice("with", other_names, comparison.other);
    comparison.other.file = reader.text("file");
    comparison.measure = reader.choice("measure", measures, comparison.measure);
    comparison.gain_stops = std::clamp(reader.number("gain", 0.0), -max_stops, max_stops);
    comparison.has_equal_brightness = reader.boolean("equal_brightness", false);
    reader.report_unknown_keys();
    return comparison;
}

PassOverride read_override(const JsonValue& value, const std::filesystem::path& file,
                           Diagnostics& problems) {
    ObjectReader reader(value, file, problems);
    PassOverride override;
    if (const std::string format = reader.text("format"); !format.empty())
        override.format = parse_format(format);
    if (reader.find("scale"))
        override.scale = reader.number("scale", 1.0);
    if (reader.find("filter"))
        override.filter = reader.choice("filter", filters, Filter::linear);
    reader.report_unknown_keys();
    return override;
}

/// Reads a session from JSON. Presets in it are read by parse_preset().
class SessionReader {
public:
    SessionReader(std::string_view text, const std::filesystem::path& file)
        : m_text(text), m_file(file) {}

    Result<Session> read() {
        const auto document = parse_json(m_text, m_file);
        if (!document)
            return fail(document.error());
        Session session;
        ObjectReader reader(*document, m_file, m_problems);
        if (accept_header(reader, session_file))
            read_session(reader, session);
        if (!m_problems.empty())
            return fail(m_problems);
        return session;
    }

private:
    void read_session(ObjectReader& reader, Session& session) {
        session.look = reader.text("look");
        if (const JsonValue* looks = reader.find("looks"))
            for (const JsonValue& entry : looks->children)
                session.looks[entry.key] = entry.text;
        session.current = state(reader.find("current"));
        m_current_cues = session.current.cues;
        session.opened = {opened_preset(reader)};
        if (const JsonValue* others = reader.find("opened"))
            read_opened(*others, session.opened);
        session.past = states(reader.find("past"));
        session.future = states(reader.find("future"));
        check_opened(session);
        session.time = reader.number("time", session.time);
        session.speed = reader.number("speed", session.speed);
        session.level = reader.number("level", session.level);
        session.is_playing = reader.boolean("is_playing", session.is_playing);
        if (reader.boolean("is_wiping", false))  // files of older versions contain only this
            session.comparison.mode = CompareMode::wipe;
        if (const JsonValue* comparison = reader.find("comparison"))
            session.comparison = read_comparison(*comparison, m_file, m_problems);
        session.follows_view = reader.boolean("follows_view", true);
        session.fits_shape = reader.boolean("fits_shape", false);
        constexpr int largest = 16384;
        session.fixed_size.width = reader.whole("width", session.fixed_size.width, 0, largest);
        session.fixed_size.height = reader.whole("height", session.fixed_size.height, 0, largest);
        session.picture_scale = reader.number("picture_scale", session.picture_scale);
        session.picture_shape = reader.text("picture_shape", session.picture_shape);
        if (const JsonValue* looks = reader.find("knobs"))
            for (const JsonValue& look : looks->children)
                for (const JsonValue& setting : look.children)
                    session.parameter_settings[look.key][setting.key] =
                        read_parameter_setting(setting, m_file, m_problems);
        if (const JsonValue* looks = reader.find("slots"))
            read_slots(*looks, session.slots);
        if (const JsonValue* stars = reader.find("preset_stars"))
            for (const JsonValue& star : stars->children)
                session.preset_stars.insert(star.text);
        if (const JsonValue* window = reader.find("window"))
            for (const JsonValue& number : window->children)
                session.window[number.key] = number.number;
        reader.report_unknown_keys();
    }

    SessionPreset opened_preset(ObjectReader& reader) {
        return {reader.text("preset_file"), state(reader.find("saved"))};
    }

    void read_opened(const JsonValue& list, std::vector<SessionPreset>& opened) {
        for (const JsonValue& value : list.children) {
            ObjectReader reader(value, m_file, m_problems);
            opened.push_back(opened_preset(reader));
            reader.report_unknown_keys();
        }
    }

    void check_opened(const Session& session) {
        for (const auto* states : {&session.past, &session.future})
            for (const SessionState& state : *states)
                if (state.opened >= session.opened.size())
                    return m_problems.push_back(
                        {m_file, 0, "'opened' is not an index of a preset"});
    }

    SessionState state(const JsonValue* value) {
        SessionState state;
        if (!value)
            return state;
        ObjectReader reader(*value, m_file, m_problems);
        state.step = reader.text("step");
        if (const JsonValue* preset = reader.require("preset"))
            state.preset = this->preset(*preset);
        if (const JsonValue* overrides = reader.find("overrides"))
            for (const JsonValue& pass : overrides->children)
                state.overrides[pass.key] = read_override(pass, m_file, m_problems);
        state.is_picture_driven = reader.boolean("picture_driven", false);
        state.locks.signal = reader.boolean("keeps_signal", false);
        state.locks.source = reader.boolean("keeps_source", false);
        state.chose_content = reader.boolean("chose_content", false);
        state.opened = static_cast<std::size_t>(reader.whole("opened", 0, 0, 1'000'000));
        state.cues = {reader.text("cue_file"), reader.text("cues")};
        if (reader.boolean("has_current_cues", false))
            state.cues = m_current_cues;
        reader.report_unknown_keys();
        return state;
    }

    Preset preset(const JsonValue& value) {
        auto read = parse_preset(m_text.substr(value.begin, value.end - value.begin), m_file);
        if (read)
            return std::move(*read);
        m_problems.insert(m_problems.end(), read.error().begin(), read.error().end());
        return {};
    }

    void read_slots(const JsonValue& looks, LookSlots& all) {
        for (const JsonValue& look : looks.children) {
            ObjectReader reader(look, m_file, m_problems);
            if (look.key.empty()) {
                m_problems.push_back({m_file, look.line, "'slots' has a look without a name"});
                continue;
            }
            Slots& slots = all[look.key];
            for (std::size_t i = 0; i < slots.size(); ++i)
                if (const JsonValue* slot = reader.find(slot_name(i))) {
                    const Preset stored = preset(*slot);
                    slots[i] = Slot{stored.name, stored.values};
                }
            reader.report_unknown_keys();
        }
    }

    std::vector<SessionState> states(const JsonValue* list) {
        std::vector<SessionState> all;
        if (list)
            for (const JsonValue& value : list->children)
                all.push_back(state(&value));
        return all;
    }

    std::string_view m_text;
    const std::filesystem::path& m_file;
    Diagnostics m_problems;
    CueText m_current_cues;
};
}  // namespace

std::string session_to_json(const Session& session) {
    const CueText& cues = session.current.cues;
    const auto& future = session.future;  // the next step is the last one
    const std::size_t past = kept_steps(session.past.rbegin(), session.past.rend(), cues);
    const std::size_t redo = kept_steps(future.rbegin(), future.rend(), cues);
    nlohmann::ordered_json window = nlohmann::ordered_json::object();
    for (const auto& [name, number] : session.window)
        window[name] = number;
    nlohmann::ordered_json json{{"format", session_file.name},
                                {"version", session_file.newest_version},
                                {"look", session.look},
                                {"looks", session.looks},
                                {"preset_file", session.opened.front().file}};
    add_state(json, "saved", session.opened.front().saved, cues);
    json["opened"] = json_of(std::span(session.opened), cues);
    add_state(json, "current", session.current, {});
    json.update({{"past", json_of(std::span(session.past).last(past), cues)},
                 {"future", json_of(std::span(future).last(redo), cues)},
                 {"time", session.time},
                 {"speed", session.speed},
                 {"level", session.level},
                 {"is_playing", session.is_playing},
                 {"comparison", json_of(session.comparison)},
                 {"follows_view", session.follows_view},
                 {"fits_shape", session.fits_shape},
                 {"width", session.fixed_size.width},
                 {"height", session.fixed_size.height},
                 {"picture_scale", session.picture_scale},
                 {"picture_shape", session.picture_shape},
                 {"knobs", json_of(session.parameter_settings)},
                 {"slots", json_of(session.slots)},
                 {"preset_stars", session.preset_stars},
                 {"window", std::move(window)}});
    return json_text(json);
}

Result<Session> parse_session(std::string_view text, const std::filesystem::path& file) {
    return SessionReader(text, file).read();
}
