#include "io/capture/open_capture.h"

#include "io/capture/screen_capture.h"
#include "io/capture/screen_cast.h"
#include "io/capture/video_stream.h"
#include "io/capture/window_capture.h"

Result<std::unique_ptr<VideoCapture>> open_capture(const LiveSpec& spec, double rate) {
    switch (spec.kind) {
        case LiveKind::window:
            return capture_window(spec.name);
        case LiveKind::screen:
            return spec.name.empty() && has_screen_cast() ? cast_screen(spec)
                                                          : capture_screen(spec);
        case LiveKind::camera:
            return open_camera(spec, rate);
        case LiveKind::pipe:
            break;
    }
    return open_pipe(spec, rate, StreamPace::live);
}
