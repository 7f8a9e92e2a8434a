// The table of contents of a pack, and the record of golden pictures.

#include "formats/pack/pack_format.h"
#include "fuzz/fuzz_files.h"
#include "lab/golden/golden_record.h"

void fuzz_one(std::string_view input) {
    if (input.starts_with('g'))
        return require_round_trip(input.substr(1), parse_golden_record, golden_record_text);
    require_round_trip(input, parse_pack, pack_to_json);
}
