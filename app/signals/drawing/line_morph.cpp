#include "signals/drawing/line_morph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace {
using Line = std::vector<BeamPosition>;

// The arc length at each point as a fraction of the line's length, 0..1.
std::vector<double> shares_of(const Line& line) {
    std::vector<double> shares(line.size(), 0.0);
    for (std::size_t i = 1; i < line.size(); ++i)
        shares[i] = shares[i - 1] + distance(line[i - 1], line[i]);
    const double length = shares.back();
    for (double& share : shares)
        share = length > 0.0 ? share / length : 0.0;
    shares.back() = 1.0;
    return shares;
}

BeamPosition lerp(const BeamPosition& a, const BeamPosition& b, double share) {
    return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share)};
}

BeamPosition position_at(const Line& line, const std::vector<double>& shares, double share) {
    const auto after = std::upper_bound(shares.begin(), shares.end(), share);
    if (after == shares.begin() || after == shares.end())
        return after == shares.end() ? line.back() : line.front();
    const auto i = static_cast<std::size_t>(after - shares.begin());
    return lerp(line[i - 1], line[i], (share - shares[i - 1]) / (shares[i] - shares[i - 1]));
}

Line positions_at(const Line& line, const std::vector<double>& shares) {
    const std::vector<double> own = shares_of(line);
    Line positions;
    for (const double share : shares)
        positions.push_back(position_at(line, own, share));
    return positions;
}

std::vector<double> even_shares(std::size_t count) {
    std::vector<double> shares;
    for (std::size_t i = 0; i < count; ++i)
        shares.push_back(static_cast<double>(i) / static_cast<double>(count));
    return shares;
}

double way_between(const Line& a, const Line& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::pow(distance(a[i], b[i]), 2.0);
    return sum;
}

// A closed line, rotated to start at another corner.
Line begun_at(const Line& line, std::size_t corner) {
    Line rotated(line.begin() + static_cast<std::ptrdiff_t>(corner), line.end() - 1);
    rotated.insert(rotated.end(), line.begin(),
                   line.begin() + static_cast<std::ptrdiff_t>(corner) + 1);
    return rotated;
}

// Rotates the closed line `to`, reversed if needed, for the smallest distance to `from`.
Line aligned(const Line& from, const Line& to) {
    constexpr std::size_t samples = 48;
    constexpr std::size_t max_tries = 64;
    constexpr double clearly = 1.0 - 1e-9;  // as drawn, unless another is better
    const Line positions = positions_at(from, even_shares(samples));
    const std::size_t stride = std::max<std::size_t>(1, (to.size() - 1) / max_tries);
    Line best = to;
    double minimum = std::numeric_limits<double>::infinity();
    for (const bool is_backwards : {false, true}) {
        const Line line = is_backwards ? Line(to.rbegin(), to.rend()) : to;
        for (std::size_t corner = 0; corner + 1 < line.size(); corner += stride) {
            Line rotated = begun_at(line, corner);
            const double way = way_between(positions, positions_at(rotated, even_shares(samples)));
            if (way < minimum * clearly) {
                minimum = way;
                best = std::move(rotated);
            }
        }
    }
    return best;
}

// The centre of a line, weighted by length.
BeamPosition middle_of(const Line& line) {
    const double length = length_of(line);
    if (length <= 0.0)
        return line.front();
    BeamPosition middle{};
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double weight = distance(line[i - 1], line[i]) / length;
        for (std::size_t axis = 0; axis < 2; ++axis)
            middle[axis] += weight * 0.5 * (line[i - 1][axis] + line[i][axis]);
    }
    return middle;
}

// The mean distance of two lines at equal fractions of their lengths.
double way_apart(const Line& a, const Line& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += distance(a[i], b[i]);
    return sum / static_cast<double>(a.size());
}

std::vector<Line> sampled(const Keyframe& strokes) {
    constexpr std::size_t samples = 16;
    std::vector<double> shares = even_shares(samples);
    shares.push_back(1.0);
    std::vector<Line> lines;
    for (const Stroke& stroke : strokes)
        lines.push_back(positions_at(line_of(stroke), shares));
    return lines;
}

using Partners = std::vector<std::optional<std::size_t>>;

// Assigns all of `fewer`, in order, to elements of `more` with the smallest total distance.
// least[i][j] is that distance for the first i of `fewer` and the first j of `more`.
Partners nearest_partners(const std::vector<Line>& fewer, const std::vector<Line>& more) {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<std::vector<double>> minimum(fewer.size() + 1,
                                             std::vector<double>(more.size() + 1, never));
    minimum[0].assign(more.size() + 1, 0.0);
    for (std::size_t i = 1; i <= fewer.size(); ++i)
        for (std::size_t j = i; j <= more.size(); ++j)
            minimum[i][j] = std::min(minimum[i][j - 1],
                                     minimum[i - 1][j - 1] + way_apart(fewer[i - 1], more[j - 1]));
    Partners partners(more.size());
    std::size_t i = fewer.size();
    for (std::size_t j = more.size(); j > 0 && i > 0; --j)
        if (minimum[i][j] < minimum[i][j - 1])
            partners[j - 1] = --i;
    return partners;
}

Partners partners_of(const Keyframe& fewer, const Keyframe& more) {
    constexpr std::size_t max_tries = 100000;  // limits the delay
    if (fewer.size() < more.size() && fewer.size() * more.size() <= max_tries)
        return nearest_partners(sampled(fewer), sampled(more));
    Partners partners(more.size());
    for (std::size_t i = 0; i < fewer.size(); ++i)
        partners[i] = i;
    return partners;
}
}  // namespace

std::vector<BeamPosition> LineMorph::at(double share) const {
    Line line;
    line.reserve(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
        line.push_back(lerp(from[i], to[i], share));
    return line;
}

LineMorph morph_of(const Stroke& from, const Stroke& to) {
    const Line a = line_of(from);
    if (from == to)
        return {a, a};
    Line b = line_of(to);
    if (a.empty() || b.empty()) {
        const Line& line = a.empty() ? b : a;
        if (line.empty())
            return {};
        const Line point(line.size(), middle_of(line));
        return a.empty() ? LineMorph{point, line} : LineMorph{line, point};
    }
    if (from.is_closed && to.is_closed && a.size() > 2 && b.size() > 2)
        b = aligned(a, b);
    constexpr double same = 1e-9;
    std::vector<double> shares = shares_of(a);
    const std::vector<double> others = shares_of(b);
    shares.insert(shares.end(), others.begin(), others.end());
    std::sort(shares.begin(), shares.end());
    const auto is_same = [](double x, double y) { return y - x < same; };
    shares.erase(std::unique(shares.begin(), shares.end(), is_same), shares.end());
    return {positions_at(a, shares), positions_at(b, shares)};
}

std::vector<LineMorph> morphs_of(const Keyframe& from, const Keyframe& to) {
    static const Stroke nothing;
    const bool is_growing = to.size() > from.size();
    const Keyframe& fewer = is_growing ? from : to;
    const Keyframe& more = is_growing ? to : from;
    const auto partners = partners_of(fewer, more);
    std::vector<LineMorph> morphs;
    for (std::size_t i = 0; i < more.size(); ++i) {
        const Stroke& other = partners[i] ? fewer[*partners[i]] : nothing;
        morphs.push_back(is_growing ? morph_of(other, more[i]) : morph_of(more[i], other));
    }
    return morphs;
}
