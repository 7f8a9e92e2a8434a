#include "gpu/renderdoc.h"

#include <array>
#include <cstddef>
#include <dlfcn.h>

namespace gpu {

namespace {
// RENDERDOC_API_1_0_0 of renderdoc_app.h is a table of 22 functions, of which TriggerCapture is the
// 16th. Later versions only append functions.
constexpr int api_version = 10000;
constexpr std::size_t function_count = 22;
constexpr std::size_t trigger_capture = 15;

using Function = void (*)();
using Api = std::array<Function, function_count>;
using GetApi = int (*)(int version, void** api);

// Null if the library is not loaded. It is never loaded here: only the launcher can do that in
// time.
const Api* find_api() {
    void* const library = dlopen("librenderdoc.so", RTLD_NOW | RTLD_NOLOAD);
    if (!library)
        return nullptr;
    const auto get = reinterpret_cast<GetApi>(dlsym(library, "RENDERDOC_GetAPI"));
    void* api = nullptr;
    const bool is_found = get && get(api_version, &api) == 1;
    dlclose(library);  // the launcher keeps it loaded
    return is_found ? static_cast<const Api*>(api) : nullptr;
}
}  // namespace

bool has_renderdoc() {
    return find_api() != nullptr;
}

void capture_next_frame() {
    if (const Api* api = find_api())
        (*api)[trigger_capture]();
}

}  // namespace gpu
