#include "lab/golden/golden_run.h"

#include "base/file.h"
#include "io/files/atomic_file.h"
#include "io/pictures/picture_file.h"
#include "io/pictures/png_encoder.h"
#include "model/picture/display_bytes.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace {
constexpr int rgb_channels = 3;
constexpr double largest_level = 255.0;

// Values are levels of 255, so that differences are exact.
Picture levels_picture(Extent extent, const std::vector<std::uint8_t>& rgb) {
    return {extent, rgb_channels, Encoding::display, std::vector<float>(rgb.begin(), rgb.end())};
}

}  // namespace

GoldenRun::GoldenRun(const GoldenRequest& request, GoldenRecord record, GoldenDriver driver,
                     GoldenDrawer drawer)
    : m_request(request),
      m_record(std::move(record)),
      m_driver(std::move(driver)),
      m_drawer(std::move(drawer)),
      m_bounds{request.levels.value_or(m_record.bounds.levels),
               request.percent.value_or(m_record.bounds.percent)} {
    if (request.updates)
        start_record();
}

// An update of all pictures changes the defaults. One of some pictures keeps them.
void GoldenRun::start_record() {
    m_record.bounds = m_bounds;
    if (!m_request.names.empty() && !m_record.pictures.empty())
        return;
    m_record.size = m_request.size.value_or(m_record.size);
    if (m_request.frames)
        m_record.frames = m_request.frames;
    for (auto& [name, picture] : m_record.pictures)
        if (!picture.driver)
            picture.driver = m_record.driver;
    m_record.driver = m_driver;
}

GoldenResult GoldenRun::started(const GoldenItem& item) const {
    GoldenResult result{.item = item};
    result.command = m_request.update_command + ' ' + item.name;
    result.size = m_request.size.value_or(m_record.size);
    result.frames = m_request.frames.value_or(m_record.frames.value_or(0));
    const auto known = m_record.pictures.find(item.name);
    if (known != m_record.pictures.end()) {
        result.size = m_request.size.value_or(known->second.size);
        result.frames = m_request.frames.value_or(known->second.frames);
    }
    const auto bytes = read_bytes(golden_picture_file(m_request, item.name));
    if (bytes)
        result.golden_png = *bytes;
    return result;
}

Result<GoldenResult> GoldenRun::result_of(const GoldenItem& item) {
    GoldenResult result = started(item);
    auto drawing = m_drawer.draw(item, result.size,
                                 result.frames > 0 ? std::optional(result.frames) : std::nullopt);
    if (!drawing) {
        result.status = GoldenStatus::broken;
        result.problems = drawing.error();
        result.note = to_string(result.problems.front());
        result.command.clear();
        return result;
    }
    result.frames = drawing->frames;
    result.problems = drawing->warnings;
    if (!drawing->skipped.empty()) {
        result.status = GoldenStatus::skipped;
        result.note = drawing->skipped;
        result.command.clear();
        return result;
    }
    compare(*drawing, result);
    if (m_request.updates) {
        if (auto written = write(*drawing, result); !written)
            return fail(written.error());
    } else if (result.status == GoldenStatus::equal) {
        result.command.clear();
    }
    if (!m_request.updates && m_record.pictures.contains(item.name) &&
        driver_of(item.name) != m_driver)
        m_drawn_elsewhere.push_back(item.name);
    return result;
}

// Also encodes the pictures for the report.
void GoldenRun::compare(const GoldenDrawing& drawing, GoldenResult& result) const {
    const fs::path file = golden_picture_file(m_request, result.item.name);
    std::error_code error;
    result.new_png = encode_png(drawing.size, drawing.rgb).value_or(std::string());
    if (!fs::exists(fs::symlink_status(file, error))) {
        result.status = GoldenStatus::missing;
        return;
    }
    if (result.golden_png == result.new_png) {  // the same pixels give the same bytes
        result.difference.emplace();
        result.new_png.clear();
        return;
    }
    result.status = GoldenStatus::different;
    const auto golden = load_picture(file);
    if (!golden) {
        result.note = golden.error().front().message;
        result.golden_png.clear();
        return;
    }
    const Picture before = levels_picture(golden->extent, display_bytes(*golden));
    const Picture now = levels_picture(drawing.size, drawing.rgb);
    const auto difference = difference_between(before, now, m_bounds.levels);
    if (!difference) {
        result.note = difference.error().front().message;
        return;
    }
    result.difference = *difference;
    if (is_within(*difference, m_bounds))
        result.status = GoldenStatus::equal;
    if (!(difference->largest > 0.0)) {
        result.new_png.clear();
        return;
    }
    result.gain = gain_to_see(difference->largest / largest_level);
    result.difference_png = encode_png(difference_picture(before, now, result.gain / largest_level))
                                .value_or(std::string());
}

Result<void> GoldenRun::write(const GoldenDrawing& drawing, GoldenResult& result) {
    const bool is_unchanged = result.difference && !(result.difference->largest > 0.0);
    if (!is_unchanged) {
        const auto png = encode_png(drawing.size, drawing.rgb);
        if (!png)
            return fail(png.error());
        if (auto written = write_atomically(golden_picture_file(m_request, result.item.name), *png);
            !written)
            return written;
        result.status =
            result.status == GoldenStatus::missing ? GoldenStatus::created : GoldenStatus::updated;
    }
    result.command.clear();
    GoldenPicture& picture = m_record.pictures[result.item.name];
    picture.size = result.size;
    picture.frames = result.frames;
    picture.driver = m_driver;  // removed by save_record() if it is that of the record
    return {};
}

Result<GoldenResult> GoldenRun::orphan(const std::string& name) {
    GoldenResult result = started({name, {}, {}, {}});
    result.status = GoldenStatus::orphaned;
    result.note = "its look or preset was removed";
    if (!m_request.updates)
        return result;
    std::error_code error;
    fs::remove(golden_picture_file(m_request, name), error);
    if (error)
        return fail({golden_picture_file(m_request, name), 0,
                     fmt::format("the picture can't be deleted: {}", error.message())});
    m_record.pictures.erase(name);
    result.status = GoldenStatus::removed;
    result.command.clear();
    return result;
}

Result<void> GoldenRun::save_record() {
    for (auto& [name, picture] : m_record.pictures)
        if (picture.driver == m_record.driver)
            picture.driver.reset();
    return write_atomically(golden_record_file(m_request), golden_record_text(m_record));
}

Diagnostics GoldenRun::warnings() const {
    if (m_drawn_elsewhere.empty())
        return {};
    return {{golden_record_file(m_request), 0,
             fmt::format("{} golden {} drawn by another driver: {}. This driver is: {}. Pictures "
                         "of different drivers can differ slightly.",
                         m_drawn_elsewhere.size(),
                         m_drawn_elsewhere.size() == 1 ? "picture was" : "pictures were",
                         to_string(driver_of(m_drawn_elsewhere.front())), to_string(m_driver)),
             Severity::warning}};
}
