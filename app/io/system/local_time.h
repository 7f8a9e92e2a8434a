#pragma once

#include <ctime>

/// The date and time of day in the user's time zone; thread-safe.
std::tm local_time(std::time_t time);
