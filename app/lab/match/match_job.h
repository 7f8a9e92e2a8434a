#pragma once

#include "lab/library/library.h"
#include "lab/match/match.h"
#include "lab/offline/prepared_look.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// A photo to match, and the look that shall look like it.
struct MatchJob {
    PreparedLook prepared;
    std::shared_ptr<const Picture> photo;  // see load_photo()
    std::filesystem::path file;            // of the photo, for messages
    Corners corners;                       // see check_photo()
    MatchChoice choice = {};
    double gamma = 2.2;  // of the camera; found for pictures, but not for beams
    Extent size = {};    // of the look's picture; empty: that of the screen in the photo, or 512
                         // lines for a beam
    std::function<void(const MatchProgress&)> on_progress = {};
    bool draws_pictures = false;                                 // for each progress
    std::function<void(const Corners&)> on_better_corners = {};  // before wrong ones are refused
};

/// A match with what it was made from.
struct MatchJobResult {
    std::string look;  // its id
    Values values;     // that were found, by parameter
    Matched matched;
    std::vector<std::pair<std::string, std::string>> types;  // parameter, label of its item
    MatchPictures pictures;                                  // empty if the match was stopped
    Extent photo;
    Extent size;  // of the look's picture
};

/// Whether the screen shows its edges in a photo. That of an oscilloscope is dark.
bool has_screen_edges(const Look& look);

/// Matches a photo in its own GL context: the picture, or the beam of a look that a signal drives.
/// Fails for looks that name no parameters, and as match_photo() and match_beam().
Result<MatchJobResult> match(MatchJob job, JobProgress& work);

/// The same for files, as the command line names them.
struct MatchFileRequest {
    RenderRequest render;  // an empty size: as in MatchJob
    std::filesystem::path photo;
    std::optional<Corners> corners = {};  // nullopt: from its edges, or those of the photo
    MatchChoice choice = {};
    double gamma = 2.2;
    std::function<void(const MatchProgress&)> on_progress = {};
};

struct MatchedFile {
    Document document;  // with the values that were found
    MatchJobResult result;
    Diagnostics warnings = {};
};
Result<MatchedFile> match_file(const MatchFileRequest& request, const Library& library,
                               JobProgress& work);

/// Sets the values in a document as one undo step. Parameters that it lacks are left out.
void set_found(Document& document, const Values& values);

/// The camera as a JSON document, see formats/photo/camera_json.h.
std::string camera_json(const MatchJobResult& result);
