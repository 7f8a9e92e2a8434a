// A library with RenderDoc's soname and entry point. It counts the captures that are triggered.
#include <cstddef>

namespace {
using Function = void (*)();

int capture_count = 0;

void trigger_capture() {
    ++capture_count;
}

// RENDERDOC_API_1_0_0: TriggerCapture follows 15 other functions.
Function functions[22] = {};
}  // namespace

extern "C" int RENDERDOC_GetAPI(int version, void** api) {
    if (version != 10000)
        return 0;
    functions[15] = trigger_capture;
    *api = static_cast<void*>(functions);
    return 1;
}

extern "C" int fake_captures() {
    return capture_count;
}
