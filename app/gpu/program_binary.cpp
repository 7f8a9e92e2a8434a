#include "gpu/program_binary.h"

#include "base/packed.h"
#include "base/text.h"
#include "gpu/context.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace gpu {

namespace {
std::vector<GLint> known_formats() {
    GLint count = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
    std::vector<GLint> formats(static_cast<std::size_t>(std::max(count, 0)));
    if (!formats.empty())
        glGetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
    return formats;
}

bool is_linked(GLuint program) {
    GLint is_good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &is_good);
    return is_good == GL_TRUE;
}
}  // namespace

std::string binary_key(std::string_view vertex, std::string_view fragment) {
    const DriverInfo info = read_info();
    return fmt::format("program {:x} {} {:x} {} {} / {} / {}", digest_of(vertex), vertex.size(),
                       digest_of(fragment), fragment.size(), info.renderer, info.vendor,
                       info.version);
}

std::string binary_of(GLuint program) {
    GLint size = 0;
    if (!known_formats().empty())
        glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &size);
    if (size <= 0)
        return {};
    std::string binary(static_cast<std::size_t>(size), '\0');
    GLsizei written = 0;
    GLenum format = 0;
    glGetProgramBinary(program, size, &written, &format, binary.data());
    binary.resize(static_cast<std::size_t>(std::max(written, 0)));
    Packer packer;
    packer.add(std::uint64_t{format});
    packer.add(binary);
    return binary.empty() ? std::string() : packer.bytes();
}

bool load_binary(GLuint program, std::string_view bytes) {
    Unpacker read(bytes);
    const std::uint64_t format = read.number(std::numeric_limits<GLint>::max());
    const std::string_view binary = read.text();
    const std::vector<GLint> formats = known_formats();
    if (!read.is_at_end() || binary.empty() ||
        std::ranges::find(formats, static_cast<GLint>(format)) == formats.end())
        return false;
    glProgramBinary(program, static_cast<GLenum>(format), binary.data(),
                    static_cast<GLsizei>(binary.size()));
    return is_linked(program);
}

}  // namespace gpu
