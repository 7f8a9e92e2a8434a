#include "model/picture/film_rate.h"

#include <cmath>

FilmRate film_rate_of(double fps) {
    constexpr int largest = 100000;
    constexpr double as_good = 1e-9;
    FilmRate nearest{static_cast<int>(std::lround(fps)), 1};
    for (int below = 1; below <= largest; ++below) {
        const FilmRate rate{static_cast<int>(std::lround(fps * below)), below};
        const double error = std::abs(rate.number() - fps);
        if (error < std::abs(nearest.number() - fps))
            nearest = rate;
        if (error <= as_good * fps)
            return rate;
    }
    return nearest;
}
