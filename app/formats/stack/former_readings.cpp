#include "formats/stack/former_readings.h"

#include "glsl/text/shader_files.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t most_readings = 8;
}

std::optional<LoadedLook> FormerReadings::find(const Question& question, ShaderFiles& disk) const {
    const auto is_same = [&disk](const SeenFile& seen) {
        if (disk.place_of(seen.file).native() != seen.place.native())
            return false;
        if (!seen.digest)
            return true;
        static_cast<void>(disk.read_plain(seen.file));
        return disk.digest_of_read(seen.file) == seen.digest;
    };
    for (const Reading& reading : m_readings)
        if (reading.question == question && std::ranges::all_of(reading.files, is_same))
            return reading.loaded;
    return std::nullopt;
}

// nullopt if `disk` does not know the content of some file.
std::optional<std::vector<FormerReadings::SeenFile>> FormerReadings::files_of(
    const LoadedLook& loaded, ShaderFiles& disk) {
    std::vector<SeenFile> files;
    for (const fs::path& file : loaded.files) {
        SeenFile seen{file, disk.place_of(file), disk.digest_of_read(file)};
        const bool is_image =
            std::ranges::find(loaded.look->images, file, &Image::file) != loaded.look->images.end();
        if (!seen.digest && !seen.place.empty() && !is_image)
            return std::nullopt;
        files.push_back(std::move(seen));
    }
    return files;
}

void FormerReadings::keep(const Question& question, const LoadedLook& loaded, ShaderFiles& disk) {
    if (!loaded.look)
        return;
    auto files = files_of(loaded, disk);
    if (!files)
        return;
    m_readings.push_front({question, loaded, std::move(*files)});
    if (m_readings.size() > most_readings)
        m_readings.pop_back();
}
