#include "lab/golden/golden_request.h"

namespace fs = std::filesystem;

fs::path golden_picture_file(const GoldenRequest& request, const std::string& name) {
    return request.directory / (name + ".png");
}

fs::path golden_record_file(const GoldenRequest& request) {
    return request.directory / "golden.json";
}

fs::path golden_report_file(const GoldenRequest& request) {
    return request.directory / "report.html";
}
