#include "io/pictures/picture_codec.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace {
// Loaded by its file name only. The loader then searches the program's run path: its own folder in
// the build, the library folder when installed.
Result<const PictureCodec*> load_module() {
    void* const module = ::dlopen(picture_codec_file, RTLD_LAZY | RTLD_LOCAL);
    void* const symbol = module ? ::dlsym(module, picture_codec_symbol) : nullptr;
    if (!symbol) {
        const char* const reason = ::dlerror();
        return fail({{},
                     0,
                     fmt::format("can't load the picture module: {}. Rebuild or reinstall "
                                 "Afterglow to read pictures and save EXR.",
                                 reason ? reason : "the module is incomplete")});
    }
    return reinterpret_cast<decltype(&afterglow_picture_codec)>(symbol)();
}
}  // namespace

Result<const PictureCodec*> picture_codec() {
    static const Result<const PictureCodec*> codec = load_module();
    return codec;
}
