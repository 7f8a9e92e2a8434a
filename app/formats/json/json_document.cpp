#include "formats/json/json_document.h"

#include "base/file.h"
#include "base/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <set>

namespace {
constexpr std::size_t largest_text = std::size_t{16} << 20;
constexpr std::size_t deepest = 128;
constexpr std::size_t max_values = 1000000;

// An iterator that counts the characters read, because the parser does not report its position.
class CountingIterator {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* count) : m_at(at), m_count(count) {}
    reference operator*() const { return *m_at; }
    CountingIterator& operator++() {
        ++m_at;
        ++*m_count;
        return *this;
    }
    CountingIterator operator++(int) {
        const CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return m_at == other.m_at; }
    bool operator!=(const CountingIterator& other) const { return m_at != other.m_at; }

private:
    const char* m_at;
    std::size_t* m_count;
};

bool is_blank(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

// Extracts the reason from "[json.exception...] parse error at line 1, column 9: syntax error while
// parsing value - REASON; last read: '...'". The location is reported separately.
std::string reason_of(std::string_view message) {
    if (message.find("number overflow") != std::string_view::npos)
        return "the number is too large";
    const std::size_t dash = message.find(" - ");
    const std::size_t colon = message.find(": ");
    if (dash != std::string_view::npos)
        message.remove_prefix(dash + 3);
    else if (colon != std::string_view::npos)
        message.remove_prefix(colon + 2);
    std::string reason(message);
    const std::size_t read = reason.find("; last read: ");
    if (read != std::string::npos)
        reason.erase(read, reason.find("; expected", read) - read);
    return fmt::format("invalid JSON: {}", reason);
}

// Builds the tree during parsing. Stops at the first error, except for duplicate keys.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
    Builder(std::string_view text, const std::filesystem::path& file, DuplicateKeys duplicate_keys)
        : m_text(text), m_file(file), m_double_keys(duplicate_keys) {}

    std::size_t* consumed() { return &m_consumed; }
    Result<JsonValue> finished() {
        if (!m_problems.empty())
            return fail(std::move(m_problems));
        return std::move(m_root);
    }

    bool null() override { return add(JsonValue::Kind::null); }
    bool boolean(bool value) override {
        m_next.boolean = value;
        return add(JsonValue::Kind::boolean);
    }
    bool number_integer(number_integer_t value) override {
        return add_number(static_cast<double>(value));
    }
    bool number_unsigned(number_unsigned_t value) override {
        return add_number(static_cast<double>(value));
    }
    bool number_float(number_float_t value, const string_t&) override { return add_number(value); }
    bool string(string_t& value) override {
        m_next.text = std::move(value);
        return add(JsonValue::Kind::text);
    }
    bool binary(binary_t&) override { return stop("invalid JSON: binary data"); }

    bool key(string_t& value) override {
        start_token();
        m_next.key_begin = m_next.begin;
        m_is_member = true;
        m_end = m_consumed;
        if (!m_open.back().keys.insert(value).second)
            note_double(value);
        m_next.key = std::move(value);
        return true;
    }

    bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::detail::exception& error) override {
        std::size_t at = m_consumed;
        while (at > 0 && is_blank(m_text[at - 1]))
            --at;
        m_next.line = line_at(at);
        if (m_consumed == 0 || trim(m_text).empty())
            return stop("the file is empty");
        return stop(reason_of(error.what()) + column_note(m_text, at > 0 ? at - 1 : 0));
    }

private:
    struct Open {
        JsonValue value;
        std::set<std::string, std::less<>> keys;
        bool has_doubles = false;
    };

    bool stop(std::string message) {
        m_problems.push_back({m_file, m_next.line, std::move(message)});
        return false;
    }

    int line_at(std::size_t at) {
        const auto first = m_text.begin() + static_cast<std::ptrdiff_t>(m_counted);
        const auto last = m_text.begin() + static_cast<std::ptrdiff_t>(std::max(at, m_counted));
        m_line += static_cast<int>(std::count(first, last, '\n'));
        m_counted = std::max(at, m_counted);
        return m_line;
    }

    // The current token begins after the previous one.
    void start_token() {
        std::size_t at = m_end;
        while (at < m_text.size() &&
               (is_blank(m_text[at]) || m_text[at] == ',' || m_text[at] == ':'))
            ++at;
        m_next.begin = at;
        if (!m_is_member) {
            m_next.key_begin = at;
            m_next.line = line_at(at);
        }
    }

    bool add_number(double value) {
        m_next.number = value;
        return add(JsonValue::Kind::number);
    }

    bool add(JsonValue::Kind kind) {
        start_token();
        m_next.kind = kind;
        m_next.end = m_consumed;
        // The parser reads one character past a number.
        while (kind == JsonValue::Kind::number && m_next.end > m_next.begin + 1 &&
               std::string_view("0123456789+-.eE").find(m_text[m_next.end - 1]) ==
                   std::string_view::npos)
            --m_next.end;
        m_end = m_next.end;
        return place(take_next());
    }

    void note_double(const std::string& key) {
        if (m_double_keys == DuplicateKeys::refused)
            add_new(m_problems, {m_file, m_next.line, fmt::format("duplicate key '{}'", key)});
        else
            m_open.back().has_doubles = true;
    }

    // Keeps the last of equal keys, in its position.
    static void drop_doubles(std::vector<JsonValue>& members) {
        std::set<std::string, std::less<>> behind;
        std::vector<JsonValue> last;
        for (std::size_t i = members.size(); i-- > 0;)
            if (behind.insert(members[i].key).second)
                last.push_back(std::move(members[i]));
        std::ranges::reverse(last);
        members = std::move(last);
    }

    JsonValue take_next() {
        m_is_member = false;
        return std::exchange(m_next, {});
    }

    bool place(JsonValue value) {
        if (++m_count > max_values)
            return stop(fmt::format("too many values; the limit is {}", max_values));
        if (m_open.empty())
            m_root = std::move(value);
        else
            m_open.back().value.children.push_back(std::move(value));
        return true;
    }

    bool open(JsonValue::Kind kind) {
        start_token();
        m_next.kind = kind;
        m_end = m_consumed;
        if (m_open.size() >= deepest)
            return stop(fmt::format("nested too deeply; the limit is {} levels", deepest));
        m_open.push_back({take_next(), {}, false});
        return true;
    }

    bool close() {
        JsonValue value = std::move(m_open.back().value);
        if (m_open.back().has_doubles)
            drop_doubles(value.children);
        m_open.pop_back();
        value.end = m_end = m_consumed;
        return place(std::move(value));
    }

    std::string_view m_text;
    const std::filesystem::path& m_file;
    DuplicateKeys m_double_keys;
    Diagnostics m_problems;
    JsonValue m_root;
    std::vector<Open> m_open;
    JsonValue m_next;            // known parts of the next value
    bool m_is_member = false;    // its key was read
    std::size_t m_consumed = 0;  // number of bytes read by the parser
    std::size_t m_end = 0;       // end of the previous token
    std::size_t m_counted = 0;   // m_line is the line of this byte
    int m_line = 1;
    std::size_t m_count = 0;
};
}  // namespace

Result<JsonValue> parse_json(std::string_view text, const std::filesystem::path& file,
                             DuplicateKeys duplicate_keys) {
    if (text.size() > largest_text)
        return fail({file, 0,
                     fmt::format("the text is too large: {} bytes; the limit is {}", text.size(),
                                 largest_text)});
    Builder builder(text, file, duplicate_keys);
    const CountingIterator first(text.data(), builder.consumed());
    const CountingIterator last(text.data() + text.size(), builder.consumed());
    nlohmann::json::sax_parse(first, last, &builder);
    return builder.finished();
}

std::string column_note(std::string_view text, std::size_t at) {
    if (trim(text).find('\n') != std::string_view::npos || at >= text.size())
        return {};
    const std::size_t line = text.substr(0, at).rfind('\n') + 1;
    return fmt::format(" (column {})", at - line + 1);
}

const JsonValue* find_member(const JsonValue& object, std::string_view key) {
    const auto found = std::find_if(object.children.begin(), object.children.end(),
                                    [&](const JsonValue& member) { return member.key == key; });
    return object.is(JsonValue::Kind::object) && found != object.children.end() ? &*found : nullptr;
}

std::string shown_json(const JsonValue& value) {
    constexpr std::size_t longest = 60;
    switch (value.kind) {
        case JsonValue::Kind::null:
            return "null";
        case JsonValue::Kind::boolean:
            return value.boolean ? "true" : "false";
        case JsonValue::Kind::number:
            return format_number(value.number);
        case JsonValue::Kind::text:
            return value.text.size() <= longest ? fmt::format("'{}'", value.text) : "'...'";
        case JsonValue::Kind::array:
            return value.children.empty() ? "[]" : "[...]";
        case JsonValue::Kind::object:
            break;
    }
    return value.children.empty() ? "{}" : "{...}";
}

std::map<std::string, int> member_lines(const std::filesystem::path& file, std::string_view key) {
    std::map<std::string, int> lines;
    const auto text = read_text(file);
    const auto document = text ? parse_json(*text, file) : fail(text.error());
    const JsonValue* member = document ? find_member(*document, key) : nullptr;
    if (member)
        for (const JsonValue& child : member->children)
            lines[child.key] = child.line;
    return lines;
}
