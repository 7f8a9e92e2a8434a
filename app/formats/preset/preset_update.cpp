#include "formats/preset/preset_update.h"

#include "formats/json/json_document.h"
#include "formats/json/json_text.h"
#include "formats/preset/preset_format.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

using Json = nlohmann::ordered_json;

namespace {
/// The text of a member, with the whitespace before it.
struct Chunk {
    std::string key;
    std::string text;
};

/// Rewrites the text of an object for the members of another document.
class ObjectUpdate {
public:
    ObjectUpdate(std::string_view text, int depth) : m_text(text), m_depth(depth) {}

    /// `before`: the object's current members; `after`: the new ones.
    std::string updated(const JsonValue& object, const Json& before, const Json& after) const {
        std::vector<Chunk> chunks = kept(object, before, after);
        for (auto member = after.begin(); member != after.end(); ++member)
            if (!find_member(object, member.key()) && !is_same(member.key(), before, after))
                insert(chunks, {member.key(), blank_for(object) + written(object, member)}, after);
        if (chunks.empty())
            return "{}";
        std::string whole = "{";
        for (const Chunk& chunk : chunks)
            whole += (whole.size() > 1 ? "," : "") + chunk.text;
        return whole + (object.children.empty() ? outer_line() : closing(object)) + "}";
    }

private:
    static bool is_same(const std::string& key, const Json& before, const Json& after) {
        return before.contains(key) && before[key] == after[key];
    }

    std::string_view slice(std::size_t begin, std::size_t end) const {
        return m_text.substr(begin, end - begin);
    }

    std::string outer_line() const {
        return '\n' + std::string(static_cast<std::size_t>(m_depth) * 2, ' ');
    }

    // The whitespace before a member, after the preceding brace or comma.
    std::string blank_before(std::size_t key_begin) const {
        const std::size_t mark = m_text.find_last_not_of(" \t\r\n", key_begin - 1);
        return std::string(slice(mark + 1, key_begin));
    }

    std::string blank_for(const JsonValue& object) const {
        return object.children.empty() ? outer_line() + "  "
                                       : blank_before(object.children.back().key_begin);
    }

    std::string closing(const JsonValue& object) const {
        return std::string(slice(object.children.back().end, object.end - 1));
    }

    bool is_on_one_line(const JsonValue& value) const {
        return slice(value.begin, value.end).find('\n') == std::string_view::npos;
    }

    std::string text_of(const Json& value, bool is_inline) const {
        return is_inline ? inline_json_text(value) : indented_json_text(value, m_depth + 1);
    }

    std::string written(const JsonValue& object, const Json::const_iterator& member) const {
        const bool is_inline = !object.children.empty() && is_on_one_line(object);
        return inline_json_text(Json(member.key())) + ": " + text_of(*member, is_inline);
    }

    std::vector<Chunk> kept(const JsonValue& object, const Json& before, const Json& after) const {
        std::vector<Chunk> chunks;
        for (const JsonValue& member : object.children) {
            if (!after.contains(member.key))
                continue;
            const std::string start =
                blank_before(member.key_begin) + std::string(slice(member.key_begin, member.begin));
            chunks.push_back({member.key, start + value_text(member, before, after)});
        }
        return chunks;
    }

    std::string value_text(const JsonValue& member, const Json& before, const Json& after) const {
        if (is_same(member.key, before, after))
            return std::string(slice(member.begin, member.end));
        const Json& value = after[member.key];
        const bool is_object = member.is(JsonValue::Kind::object) && value.is_object() &&
                               before.contains(member.key) && before[member.key].is_object();
        const bool has_other_kind =
            is_object && before[member.key].value("kind", "") != value.value("kind", "");
        if (is_object && !has_other_kind)
            return ObjectUpdate(m_text, m_depth + 1).updated(member, before[member.key], value);
        return text_of(value, is_on_one_line(member));
    }

    // Inserts before the first later member: in the order of the format at the top level, by name
    // below.
    void insert(std::vector<Chunk>& chunks, Chunk chunk, const Json& after) const {
        const auto order_of = [&](const std::string& key) {
            return std::distance(after.begin(), after.find(key));
        };
        const auto later = std::ranges::find_if(chunks, [&](const Chunk& other) {
            return m_depth == 0 ? order_of(other.key) > order_of(chunk.key)
                                : other.key != "kind" && other.key > chunk.key;
        });
        chunks.insert(later, std::move(chunk));
    }

    std::string_view m_text;
    int m_depth;
};
}  // namespace

std::string updated_preset_text(std::string_view text, const Preset& preset, const Look* look) {
    const auto document = parse_json(text, {});
    auto before = parse_preset(text, {});
    if (!document || !before)
        return preset_to_json(preset, look);
    if (look)
        if (auto fitted = fitted_values(*look, *before, {}))
            before->values = std::move(*fitted);
    const std::string object = ObjectUpdate(text, 0).updated(*document, preset_json(*before, look),
                                                             preset_json(preset, look));
    return std::string(text.substr(0, document->begin)) + object +
           std::string(text.substr(document->end));
}
