#include "lab/storage/local_date.h"

#include "io/system/local_time.h"

#include <chrono>
#include <ctime>

Date local_date() {
    const auto now = std::chrono::system_clock::now();
    const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
    const std::chrono::duration<double> part =
        now - std::chrono::system_clock::from_time_t(seconds);
    const std::tm local = local_time(seconds);
    return {local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
            local.tm_hour * 3600.0 + local.tm_min * 60.0 + local.tm_sec + part.count()};
}
