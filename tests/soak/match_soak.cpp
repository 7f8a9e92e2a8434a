// Matches synthetic photos and prints a line of JSON per photo.
#include "match/trial.h"

#include <fmt/format.h>

#include <cstdlib>

int main(int count, char** arguments) {
    if (count != 5) {
        fmt::print(stderr, "usage: match_soak SEED MASK CORNER_ERROR FOLDER\n");
        return 2;
    }
    const Trial trial{std::atoi(arguments[1]), std::atoi(arguments[2]), std::atof(arguments[3])};
    const auto result = run_trial(trial, arguments[4]);
    if (!result) {
        fmt::print("{{\"seed\": {}, \"mask\": {}, \"corner_error\": {}, \"error\": \"{}\"}}\n",
                   trial.seed, trial.mask, trial.corner_error, result.error().front().message);
        return 1;
    }
    fmt::print(
        "{{\"seed\": {}, \"mask\": {}, \"corner_error\": {}, \"seconds\": {:.2f}, "
        "\"pictures\": {}, \"residual\": {:.5f}, \"residual_of_truth\": {:.5f}, "
        "\"type\": {}",
        trial.seed, trial.mask, trial.corner_error, result->seconds, result->matched.pictures,
        result->matched.residual, result->residual_of_truth,
        result->matched.state.values.at("mask_type").number());
    for (const FoundNumber& number : result->matched.numbers)
        fmt::print(", \"{}\": [{:.5f}, {:.5f}, {:.5f}, {:.5f}]", number.parameter,
                   result->truth.at(number.parameter), number.value, number.low, number.high);
    fmt::print("}}\n");
    return 0;
}
