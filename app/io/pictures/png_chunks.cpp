#include "io/pictures/png_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <zlib.h>

namespace {
// Length, type and checksum have four bytes each (PNG specification, 5.3).
constexpr std::size_t word_size = 4;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < word_size; ++i)
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

void append_number(std::string& bytes, std::size_t number) {
    for (const unsigned shift : {24u, 16u, 8u, 0u})
        bytes += static_cast<char>((number >> shift) & 0xffu);
}

std::uint32_t check_sum(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        ::crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

bool is_type(std::string_view type) {
    return std::all_of(type.begin(), type.end(), [](char letter) {
        return (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
    });
}
}  // namespace

std::string_view png_signature() {
    return "\x89PNG\r\n\x1a\n";
}

bool is_png(std::string_view bytes) {
    return bytes.starts_with(png_signature());
}

Result<std::vector<PngChunk>> parse_png_chunks(std::string_view bytes) {
    if (!is_png(bytes))
        return fail({{}, 0, "not a PNG file"});
    std::vector<PngChunk> chunks;
    for (std::size_t at = png_signature().size();;) {
        const std::size_t left = bytes.size() - at;
        if (left < 3 * word_size || number_at(bytes, at) > left - 3 * word_size)
            return fail({{}, 0, "the PNG is damaged: it ends early"});
        const std::size_t length = number_at(bytes, at);
        const PngChunk chunk{bytes.substr(at + word_size, word_size),
                             bytes.substr(at + 2 * word_size, length),
                             bytes.substr(at, length + 3 * word_size)};
        const std::uint32_t sum = number_at(bytes, at + 2 * word_size + length);
        if (!is_type(chunk.type) ||
            check_sum(bytes.substr(at + word_size, word_size + length)) != sum)
            return fail({{}, 0, fmt::format("the PNG is damaged: wrong checksum at byte {}", at)});
        if (chunks.empty() != (chunk.type == "IHDR"))
            return fail({{}, 0, "the PNG is damaged: it doesn't start with its header"});
        chunks.push_back(chunk);
        at += chunk.whole.size();
        if (chunk.type == "IEND")
            return chunks;
    }
}

std::string fault_of_png(const std::vector<PngChunk>& chunks) {
    const std::string_view header = chunks.empty() ? std::string_view() : chunks.front().data;
    if (chunks.empty() || chunks.front().type != "IHDR" || header.size() != 13)
        return "the PNG is damaged: it has no header";
    const std::uint32_t width = number_at(header, 0);
    const std::uint32_t height = number_at(header, 4);
    constexpr std::uint32_t maximum = 0x7fffffff;
    if (width < 1 || height < 1 || width > maximum || height > maximum)
        return fmt::format("the PNG is damaged: its size is {} x {} px", width, height);
    // The valid bit depths of each colour type.
    const std::map<int, std::string_view> depths{{0, "\x01\x02\x04\x08\x10"},
                                                 {2, "\x08\x10"},
                                                 {3, "\x01\x02\x04\x08"},
                                                 {4, "\x08\x10"},
                                                 {6, "\x08\x10"}};
    const int color = static_cast<unsigned char>(header[9]);
    const auto known = depths.find(color);
    if (known == depths.end() || known->second.find(header[8]) == std::string_view::npos)
        return fmt::format("the PNG is damaged: bit depth {} is invalid for colour type {}",
                           int{header[8]}, color);
    if (header[10] != 0 || header[11] != 0 || header[12] < 0 || header[12] > 1)
        return "the PNG is damaged: unknown compression, filter or interlacing";
    const auto has = [&](std::string_view type) {
        return std::ranges::find(chunks, type, &PngChunk::type) != chunks.end();
    };
    if (color == 3 && !has("PLTE"))
        return "the PNG is damaged: it has no palette";
    return has("IDAT") ? "" : "the PNG is damaged: it has no pixels";
}

std::string png_chunk(std::string_view type, std::string_view data) {
    std::string chunk;
    append_number(chunk, data.size());
    chunk.append(type).append(data);
    append_number(chunk, check_sum(std::string_view(chunk).substr(word_size)));
    return chunk;
}
