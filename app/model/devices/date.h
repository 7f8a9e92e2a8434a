#pragma once

/// A date and the time of day.
struct Date {
    int year = 2000;
    int month = 1;         // from 1
    int day = 1;           // from 1
    double seconds = 0.0;  // since midnight

    bool operator==(const Date&) const = default;
};

/// The date of time 0 for renders to files, so that they are reproducible: 2000-01-01, midnight.
constexpr Date date_of_renders{};

/// The date `seconds` later.
Date date_after(const Date& date, double seconds);
