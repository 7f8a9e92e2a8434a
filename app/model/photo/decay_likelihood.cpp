#include "model/photo/decay_likelihood.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace {
using Square = Eigen::Matrix4d;
using Four = Eigen::Vector4d;  // what red, green and blue of the phosphor add, and the background

constexpr double own_width = 0.4;
constexpr double other_width = 0.1;
constexpr double background_width = 0.02;  // of the most light

// The light of each frame of the video when the light goes off `phase` steps before the first.
std::vector<glm::dvec3> frames_of(const std::vector<glm::dvec3>& response, std::size_t count,
                                  int lit_frames, int steps, int phase) {
    const auto pulse = static_cast<std::size_t>(lit_frames <= 2 ? 1 : lit_frames * steps);
    std::vector<glm::dvec3> summed(response.size() + 1, glm::dvec3(0.0));
    for (std::size_t i = 0; i < response.size(); ++i)
        summed[i + 1] = summed[i] + response[i];
    const auto between = [&](std::size_t from, std::size_t to) {
        const std::size_t last = response.size();
        return summed[std::min(to, last)] - summed[std::min(from, last)];
    };
    std::vector<glm::dvec3> frames(count, glm::dvec3(0.0));
    for (std::size_t frame = 0; frame < count; ++frame)
        for (int step = 0; step < steps; ++step) {
            const std::size_t after =
                frame * static_cast<std::size_t>(steps) + static_cast<std::size_t>(phase + step);
            frames[frame] += between(after + 1, after + 1 + pulse);
        }
    return frames;
}

// One channel of the video as a linear model, with its products weighted by 1 / variance.
struct Channel {
    Square squares = Square::Zero();
    Four products = Four::Zero();
    double square = 0.0;        // of the recorded light
    double log_variance = 0.0;  // sum
};

Channel channel_of(const LightCurve& curve, const std::vector<glm::dvec3>& frames,
                   glm::length_t channel) {
    Channel sums;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Four row(frames[i].r, frames[i].g, frames[i].b, 1.0);
        const double weight = 1.0 / curve.variance[i][channel];
        const double light = curve.light[i][channel];
        sums.squares += weight * row * row.transpose();
        sums.products += weight * light * row;
        sums.square += weight * light * light;
        sums.log_variance -= std::log(weight);
    }
    return sums;
}

struct Posterior {
    double logarithm = 0.0;
    Four amounts = Four::Zero();
};

Posterior posterior_of(const Channel& sums, glm::length_t channel, double gain, double most,
                       std::size_t count) {
    Four expected = Four::Zero();
    expected[channel] = gain;
    Four widths(other_width * gain, other_width * gain, other_width * gain,
                background_width * most);
    widths[channel] = own_width * gain;
    const Four precisions = widths.cwiseProduct(widths).cwiseInverse();
    const Square total = sums.squares + Square(precisions.asDiagonal());
    const Four miss = sums.products - sums.squares * expected;
    const Eigen::LLT<Square> solver(total);
    const Four change = solver.solve(miss);
    const double square = sums.square - 2.0 * expected.dot(sums.products) +
                          expected.dot(sums.squares * expected) - miss.dot(change);
    const double log_determinant =
        2.0 * solver.matrixLLT().diagonal().array().log().sum() - precisions.array().log().sum();
    const double normal = static_cast<double>(count) * std::log(2.0 * std::numbers::pi);
    return {-0.5 * (square + sums.log_variance + log_determinant + normal), expected + change};
}

double most_of(const std::vector<glm::dvec3>& light) {
    double most = 0.0;
    for (const glm::dvec3& rgb : light)
        most = std::max({most, rgb.r, rgb.g, rgb.b});
    return most;
}

// The gain of least squares, with the phosphor's own colours.
double plain_gain(const std::array<Channel, 3>& channels) {
    double product = 0.0;
    double square = 0.0;
    for (Eigen::Index i = 0; i < 3; ++i) {
        product += channels[static_cast<std::size_t>(i)].products[i];
        square += channels[static_cast<std::size_t>(i)].squares(i, i);
    }
    return square > 0.0 ? product / square : 0.0;
}

// The likelihood with the light of each frame, which is at most 1.
DecayLikelihood with_frames(const LightCurve& curve, const std::vector<glm::dvec3>& frames) {
    std::array<Channel, 3> channels;
    for (glm::length_t i = 0; i < 3; ++i)
        channels[static_cast<std::size_t>(i)] = channel_of(curve, frames, i);
    const double plain = std::max(plain_gain(channels), 1e-6);
    DecayLikelihood best{-std::numeric_limits<double>::infinity(), 0.0};
    std::array<Four, 3> amounts{};
    constexpr int reach = 6;  // a gain between half and twice the plain one
    for (int i = -reach; i <= reach; ++i) {
        const double gain = plain * std::exp2(static_cast<double>(i) / reach);
        double logarithm = 0.0;
        std::array<Four, 3> found{};
        for (glm::length_t channel = 0; channel < 3; ++channel) {
            const auto index = static_cast<std::size_t>(channel);
            const Posterior posterior =
                posterior_of(channels[index], channel, gain, most_of(curve.light), frames.size());
            logarithm += posterior.logarithm;
            found[index] = posterior.amounts;
        }
        if (logarithm > best.logarithm) {
            best.logarithm = logarithm;
            amounts = found;
        }
    }
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Four row(frames[i].r, frames[i].g, frames[i].b, 1.0);
        const glm::dvec3 light(amounts[0].dot(row), amounts[1].dot(row), amounts[2].dot(row));
        const glm::dvec3 miss = light - curve.light[i];
        const glm::dvec3 squares = miss * miss / curve.variance[i];
        best.misfit +=
            (squares.r + squares.g + squares.b) / (3.0 * static_cast<double>(frames.size()));
    }
    return best;
}
}  // namespace

DecayLikelihood decay_likelihood(const RecordedDecay& recorded,
                                 const std::vector<glm::dvec3>& response, int steps) {
    DecayLikelihood best{-std::numeric_limits<double>::infinity(), 0.0};
    for (int phase = 0; phase < steps; ++phase) {
        std::vector<glm::dvec3> frames =
            frames_of(response, recorded.curve.light.size(), recorded.lit_frames, steps, phase);
        const double most = most_of(frames);
        if (most <= 0.0)
            continue;
        for (glm::dvec3& light : frames)
            light /= most;
        const DecayLikelihood here = with_frames(recorded.curve, frames);
        if (here.logarithm > best.logarithm)
            best = here;
    }
    return best;
}
