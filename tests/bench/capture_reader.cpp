// Reads a live source: capture_reader SOURCE. For each picture it prints the time of the monotonic
// clock in s, and the first pixel's red, green and blue. Ends when its input ends.
#include "io/capture/open_capture.h"

#include <chrono>
#include <cstdio>
#include <poll.h>

int main(int count, char** words) {
    const auto spec = parse_live(count == 2 ? words[1] : "");
    auto capture = spec ? open_capture(*spec, 0.0) : fail(spec.error());
    if (!capture) {
        std::fprintf(stderr, "%s\n", capture.error().front().message.c_str());
        return 1;
    }
    pollfd input{0, POLLIN, 0};
    while (poll(&input, 1, 0) == 0) {
        const auto picture = (*capture)->read(0.1);
        if (!picture)
            return 1;
        if (!*picture)
            continue;
        const std::chrono::duration<double> now =
            std::chrono::steady_clock::now().time_since_epoch();
        const std::uint8_t* const pixel = (*picture)->bytes.get();
        std::printf("%.6f %d %d %d\n", now.count(), pixel[2], pixel[1], pixel[0]);
        std::fflush(stdout);
    }
    return 0;
}
