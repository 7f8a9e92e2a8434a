#include "model/devices/date.h"

#include <chrono>
#include <cmath>

Date date_after(const Date& date, double seconds) {
    constexpr double seconds_per_day = 86400.0;
    const double since_midnight = date.seconds + seconds;
    const double days = std::floor(since_midnight / seconds_per_day);
    const std::chrono::sys_days first = std::chrono::year(date.year) / date.month /
                                        std::chrono::day(static_cast<unsigned>(date.day));
    const std::chrono::year_month_day then(first + std::chrono::days(static_cast<int>(days)));
    return {static_cast<int>(then.year()), static_cast<int>(static_cast<unsigned>(then.month())),
            static_cast<int>(static_cast<unsigned>(then.day())),
            since_midnight - days * seconds_per_day};
}
