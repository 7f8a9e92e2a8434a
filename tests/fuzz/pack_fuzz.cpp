// The table of contents of a pack, and the record of golden pictures.

#include "formats/pack/pack_format.h"
#include "fuzz/fuzz_files.h"
#include "lab/golden/golden_record.h"

void fuzz_one(std::string_view input) {
    if (input.starts_with('g')) {
        const auto record = parse_golden_record(input.substr(1), "golden.json");
        if (!record)
            return require_reasons(record.error());
        const auto again = parse_golden_record(golden_record_text(*record), "again.json");
        require(again.has_value() && *again == *record, "a record stays the same");
        return;
    }
    const auto manifest = parse_pack(input, "pack.json");
    if (!manifest)
        return require_reasons(manifest.error());
    const auto again = parse_pack(pack_to_json(*manifest), "again.json");
    require(again.has_value() && pack_to_json(*again) == pack_to_json(*manifest),
            "a table of contents stays the same");
}
