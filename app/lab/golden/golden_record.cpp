#include "lab/golden/golden_record.h"

#include "base/file.h"
#include "formats/json/json_text.h"
#include "formats/json/object_reader.h"
#include "lab/golden/golden_name.h"
#include "lab/rendering/named_size.h"
#include "model/look/look.h"

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
constexpr FileFormat record_file{"afterglow-golden", 1};

template <class T>
T parsed_text(ObjectReader& reader, std::string_view key, T fallback, std::string_view expected,
              const std::function<std::optional<T>(const std::string&)>& parse) {
    const JsonValue* value = reader.find(key);
    if (!value || !reader.expect(*value, JsonValue::Kind::text))
        return fallback;
    if (const auto parsed = parse(value->text))
        return *parsed;
    reader.problem(*value, fmt::format("'{}' must be {}, got '{}'", key, expected, value->text));
    return fallback;
}

Extent read_size(ObjectReader& reader, Extent fallback) {
    return parsed_text<Extent>(reader, "size", fallback, "WIDTHxHEIGHT", parse_extent);
}

GoldenDriver read_driver(const JsonValue& value, ObjectReader& around) {
    ObjectReader reader(value, around.file(), around.problems());
    GoldenDriver driver{reader.text("vendor"), reader.text("renderer"), reader.text("version")};
    reader.report_unknown_keys();
    return driver;
}

GoldenPicture read_picture(const JsonValue& value, const GoldenRecord& record,
                           ObjectReader& around) {
    ObjectReader reader(value, around.file(), around.problems());
    GoldenPicture picture{read_size(reader, record.size),
                          reader.whole("frames", 1, 1, max_settle_frames)};
    if (const JsonValue* driver = reader.find("driver"))
        picture.driver = read_driver(*driver, reader);
    reader.report_unknown_keys();
    return picture;
}

void read_record(ObjectReader& reader, GoldenRecord& record) {
    record.bounds.levels =
        parsed_text<double>(reader, "max", record.bounds.levels, "a difference from 0 to 255/255",
                            [](const std::string& text) { return parse_levels(text); });
    record.bounds.percent =
        parsed_text<double>(reader, "share", record.bounds.percent, "a share from 0 to 100 %",
                            [](const std::string& text) { return parse_percent(text); });
    record.size = read_size(reader, record.size);
    if (reader.find("frames"))
        record.frames = reader.whole("frames", 1, 1, max_settle_frames);
    if (const JsonValue* driver = reader.find("driver"))
        record.driver = read_driver(*driver, reader);
    const JsonValue* pictures = reader.find("pictures");
    if (!pictures || !reader.expect(*pictures, JsonValue::Kind::object))
        return;
    for (const JsonValue& picture : pictures->children) {
        if (is_golden_name(picture.key))
            record.pictures[picture.key] = read_picture(picture, record, reader);
        else
            reader.problem(picture,
                           fmt::format("'{}' can't be the name of a golden picture", picture.key));
    }
}

Json json_of(const GoldenDriver& driver) {
    return {{"vendor", driver.vendor}, {"renderer", driver.renderer}, {"version", driver.version}};
}
}  // namespace

std::string to_string(const GoldenDriver& driver) {
    return fmt::format("{}, {}, {}", driver.renderer, driver.vendor, driver.version);
}

std::string dimensions_text(Extent size) {
    return fmt::format("{}x{}", size.width, size.height);
}

Result<GoldenRecord> parse_golden_record(std::string_view text, const fs::path& file) {
    const auto document = parse_json(text, file);
    if (!document)
        return fail(document.error());
    Diagnostics problems;
    ObjectReader reader(*document, file, problems);
    GoldenRecord record;
    if (accept_header(reader, record_file)) {
        read_record(reader, record);
        reader.report_unknown_keys();
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return record;
}

Result<GoldenRecord> load_golden_record(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(file, error)))
        return GoldenRecord{};
    const auto text = read_text(file);
    return text ? parse_golden_record(*text, file) : fail(text.error());
}

std::string golden_record_text(const GoldenRecord& record) {
    Json json{{"format", record_file.name},
              {"version", record_file.newest_version},
              {"max", levels_text(record.bounds.levels)},
              {"share", percent_text(record.bounds.percent)},
              {"size", dimensions_text(record.size)}};
    if (record.frames)
        json["frames"] = *record.frames;
    json["driver"] = json_of(record.driver);
    json["pictures"] = Json::object();
    for (const auto& [name, picture] : record.pictures) {
        Json& entry = json["pictures"][name];
        entry = {{"size", dimensions_text(picture.size)}, {"frames", picture.frames}};
        if (picture.driver)
            entry["driver"] = json_of(*picture.driver);
    }
    return json_text(json);
}
