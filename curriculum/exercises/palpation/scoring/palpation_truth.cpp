// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"

#include "modules/exercises/palpation/cues/findings_book.h"
#include "scoring/truth_reader.h"

#include <cstddef>
#include <string>

namespace chiron::scoring {

namespace {

constexpr int kMostRegions = 64; ///< per side

constexpr int kMostLumps = static_cast<int>(simulation::kMaxShownLumps);
constexpr int kHardest = static_cast<int>(simulation::FindingsBook::kHighestRating);

std::string lumpId(int number, const char* field) {
    return "lump_" + std::to_string(number) + "_" + field;
}

LumpTruth lumpOf(TruthReader& read, int number) {
    LumpTruth lump;
    lump.place_W = {read.number(lumpId(number, "x_m")), read.number(lumpId(number, "y_m")),
                    read.number(lumpId(number, "z_m"))};
    lump.depth_m = read.number(lumpId(number, "depth_m"));
    lump.radius_m = read.atLeast(0.0, lumpId(number, "radius_m"));
    lump.hardness = read.count(lumpId(number, "hardness"), 0, kHardest);
    return lump;
}

void addLump(std::vector<NamedValue>& values, const LumpTruth& lump, int number) {
    addRecorded(values, lumpId(number, "x_m"), lump.place_W.x());
    addRecorded(values, lumpId(number, "y_m"), lump.place_W.y());
    addRecorded(values, lumpId(number, "z_m"), lump.place_W.z());
    addRecorded(values, lumpId(number, "depth_m"), lump.depth_m);
    addRecorded(values, lumpId(number, "radius_m"), lump.radius_m);
    addRecorded(values, lumpId(number, "hardness"), lump.hardness);
}

} // namespace

core::Result<PalpationTruth> palpationTruthOf(std::span<const NamedValue> values) {
    TruthReader read(values);
    PalpationTruth out;
    const int lumps = read.count("lumps", 0, kMostLumps);
    for (int i = 0; i < lumps; ++i)
        out.lumps.push_back(lumpOf(read, i));
    out.areaHalf_m = {read.atLeast(1e-6, "area_half_x_m"), read.atLeast(1e-6, "area_half_y_m")};
    out.regionColumns = read.count("region_columns", 1, kMostRegions);
    out.regionRows = read.count("region_rows", 1, kMostRegions);
    out.hitRadius_m = read.atLeast(0.0, "hit_radius_m");
    const PalpationBand band = palpationBandOf(values);
    out.bandLow_N = band.low_N.value_or(0.0);
    out.bandHigh_N = band.high_N.value_or(0.0);
    out.coverForce_N = read.optional("cover_force_N").value_or(0.0);
    const auto isSet = [&read](const char* id) { return read.optional(id).value_or(0.0) != 0.0; };
    out.introduction = isSet("introduction");
    out.asksSize = isSet("asks_size");
    out.asksHardness = isSet("asks_hardness");
    CHIRON_TRY(read.done());
    return out;
}

PalpationBand palpationBandOf(std::span<const NamedValue> values) {
    const TruthReader read(values);
    return {read.optional("band_low_N"), read.optional("band_high_N")};
}

std::vector<NamedValue> valuesOf(const PalpationTruth& truth) {
    std::vector<NamedValue> values;
    addRecorded(values, "lumps", static_cast<double>(truth.lumps.size()));
    if (truth.introduction) // sessions before it existed have no such value
        addRecorded(values, "introduction", 1.0);
    for (std::size_t i = 0; i < truth.lumps.size(); ++i)
        addLump(values, truth.lumps[i], static_cast<int>(i));
    addRecorded(values, "area_half_x_m", truth.areaHalf_m.x());
    addRecorded(values, "area_half_y_m", truth.areaHalf_m.y());
    addRecorded(values, "region_columns", truth.regionColumns);
    addRecorded(values, "region_rows", truth.regionRows);
    addRecorded(values, "hit_radius_m", truth.hitRadius_m);
    addRecorded(values, "band_low_N", truth.bandLow_N);
    addRecorded(values, "band_high_N", truth.bandHigh_N);
    addRecorded(values, "cover_force_N", truth.coverForce_N);
    addRecorded(values, "asks_size", truth.asksSize ? 1.0 : 0.0);
    addRecorded(values, "asks_hardness", truth.asksHardness ? 1.0 : 0.0);
    return values;
}

} // namespace chiron::scoring
