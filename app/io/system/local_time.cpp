#include "io/system/local_time.h"

std::tm local_time(std::time_t time) {
    std::tm local = {};
    ::localtime_r(&time, &local);
    return local;
}
