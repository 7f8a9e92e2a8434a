#include "formats/preset/preset_png.h"

#include "formats/preset/deflate.h"
#include "formats/preset/preset_format.h"
#include "io/pictures/png_chunks.h"

#include <fmt/format.h>

#include <optional>

namespace {
// PNG specification, 11.3.4: keyword, NUL; for iTXt the compression flag and method, a language and
// a translated keyword, each ended by NUL; then the text.
constexpr std::string_view keyword("afterglow-preset\0", 17);
constexpr std::string_view compressed_header("\1\0\0\0", 4);

bool is_preset(const PngChunk& chunk) {
    const bool is_text = chunk.type == "iTXt" || chunk.type == "zTXt" || chunk.type == "tEXt";
    return is_text && chunk.data.starts_with(keyword);
}

std::optional<std::string> international_text(std::string_view data) {
    if (data.size() < 4 || data[1] != 0)
        return std::nullopt;
    const bool is_compressed = data[0] == 1;
    data.remove_prefix(2);
    for (int skipped = 0; skipped < 2; ++skipped) {
        const std::size_t zero = data.find('\0');
        if (zero == std::string_view::npos)
            return std::nullopt;
        data.remove_prefix(zero + 1);
    }
    return is_compressed ? inflate_bytes(data, largest_preset) : std::optional(std::string(data));
}

std::optional<std::string> text_of(const PngChunk& chunk) {
    const std::string_view data = chunk.data.substr(keyword.size());
    if (chunk.type == "iTXt")
        return international_text(data);
    if (chunk.type == "tEXt")
        return std::string(data);
    return data.starts_with('\0') ? inflate_bytes(data.substr(1), largest_preset) : std::nullopt;
}
}  // namespace

Result<std::string> with_preset(std::string_view png, const Preset& preset, const Look* look) {
    const auto chunks = parse_png_chunks(png);
    if (!chunks)
        return fail(chunks.error());
    const std::string data = std::string(keyword).append(compressed_header) +
                             deflate_bytes(preset_to_json(preset, look));
    std::string bytes(png_signature());
    for (const PngChunk& chunk : *chunks) {
        if (!is_preset(chunk))
            bytes.append(chunk.whole);
        if (chunk.type == "IHDR")
            bytes.append(png_chunk("iTXt", data));
    }
    return bytes;
}

Result<Preset> preset_from_png(std::string_view png, const std::filesystem::path& file) {
    const auto chunks = parse_png_chunks(png);
    if (!chunks)
        return fail({file, 0, chunks.error().front().message});
    for (const PngChunk& chunk : *chunks) {
        if (!is_preset(chunk))
            continue;
        const auto text = text_of(chunk);
        if (!text)
            return fail({file, 0, "the preset in the PNG is damaged"});
        auto preset = parse_preset(*text, file);
        if (!preset)
            for (Diagnostic& reason : preset.error())
                reason = {file, 0,
                          fmt::format("the preset in the PNG is invalid: {}", reason.message)};
        return preset;
    }
    return fail({file, 0, "the PNG doesn't contain a preset"});
}
