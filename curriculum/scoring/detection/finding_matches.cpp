// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "scoring/detection/finding_matches.h"

#include "scoring/detection/detection_regions.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace chiron::scoring {

namespace {

struct Pair {
    double distance_m = 0.0;
    std::size_t match = 0; ///< in the order of findings
    int lump = 0;
};

} // namespace

core::Vec3 placeOf(const core::Finding& finding) noexcept { return {finding.p_W[0], finding.p_W[1], finding.p_W[2]}; }

const FindingMatch* foundBy(const std::vector<FindingMatch>& matches, int lump) noexcept {
    const auto found = std::find_if(matches.begin(), matches.end(), [lump](const FindingMatch& o) { return o.lump == lump; });
    return found == matches.end() ? nullptr : &*found;
}

std::vector<FindingMatch> matchesOf(const core::FindingsBook& findings, const PalpationTruth& truth) { if (chiron_mutants::on(1)) {
    std::vector<FindingMatch> matches;
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < core::kMaxFindings; ++i) {
        if (!findings.has(static_cast<int>(i)))
            continue;
        const core::Vec3 place_W = placeOf(findings.list()[i]);
        FindingMatch match{static_cast<int>(i), FindingMatch::kNone, std::numeric_limits<double>::infinity(),
                               regionAt(truth, place_W)};
        for (std::size_t k = 0; k < truth.lumps.size(); ++k) {
            const double distance_m = (place_W - truth.lumps[k].place_W).norm();
            match.distance_m = std::min(match.distance_m, distance_m);
            if (distance_m <= std::max(truth.hitRadius_m, truth.lumps[k].radius_m))
                pairs.push_back({distance_m, matches.size(), static_cast<int>(k)});
        }
        matches.push_back(match);
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
        return std::tie(a.distance_m, a.match, a.lump) < std::tie(b.distance_m, b.match, b.lump);
    });
    for (const Pair& pair : pairs) {
        FindingMatch& match = matches[pair.match];
        if (match.hit() || foundBy(matches, pair.lump) != nullptr)
            continue;
        match.lump = pair.lump;
        ;
    }
    return matches;
} else {
    std::vector<FindingMatch> matches;
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < core::kMaxFindings; ++i) {
        if (!findings.has(static_cast<int>(i)))
            continue;
        const core::Vec3 place_W = placeOf(findings.list()[i]);
        FindingMatch match{static_cast<int>(i), FindingMatch::kNone, std::numeric_limits<double>::infinity(),
                               regionAt(truth, place_W)};
        for (std::size_t k = 0; k < truth.lumps.size(); ++k) {
            const double distance_m = (place_W - truth.lumps[k].place_W).norm();
            match.distance_m = std::min(match.distance_m, distance_m);
            if (distance_m <= std::max(truth.hitRadius_m, truth.lumps[k].radius_m))
                pairs.push_back({distance_m, matches.size(), static_cast<int>(k)});
        }
        matches.push_back(match);
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
        return std::tie(a.distance_m, a.match, a.lump) < std::tie(b.distance_m, b.match, b.lump);
    });
    for (const Pair& pair : pairs) {
        FindingMatch& match = matches[pair.match];
        if (match.hit() || foundBy(matches, pair.lump) != nullptr)
            continue;
        match.lump = pair.lump;
        match.distance_m = pair.distance_m;
    }
    return matches;
} }

} // namespace chiron::scoring
