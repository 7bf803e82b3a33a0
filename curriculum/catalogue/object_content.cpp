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
#include "catalogue/object_content.h"

#include "core/units.h"

#include <cmath>

namespace chiron::catalogue {

namespace {

using Object = simulation::ObjectAttributes;

struct Key {
    const char* name;
    double Object::*member;
    double perUnit; ///< content's units in one SI unit
};

constexpr double kMm = 1e3;
constexpr double kUm = 1e6;
constexpr double kGrams = 1e3;

constexpr Key kKeys[] = {
    {"stiffness_N_per_m", &Object::stiffness_N_per_m, 1.0},
    {"stiffening_per_m", &Object::stiffening_per_m, 1.0},
    {"mass_g", &Object::mass_kg, kGrams},
    {"recovery_s", &Object::recoveryTime_s, 1.0},
    {"recovery_share", &Object::recoveryShare, 1.0},
    {"roughness_um", &Object::roughness_m, kUm},
    {"roughness_wavelength_mm", &Object::roughnessWavelength_m, kMm},
    {"friction", &Object::friction, 1.0},
    {"bristle_stiffness_N_per_m", &Object::bristleStiffness_N_per_m, 1.0},
    {"viscosity_N_s_per_m", &Object::viscosity_Ns_per_m, 1.0},
    {"damping_N_s_per_m", &Object::damping_Ns_per_m, 1.0},
};

/// Steepest slope that a micro-height may have, root mean square: about a third, so that d + h stays a surface.
constexpr double kSteepest = 0.35;

} // namespace

Object readObject(const ObjectReader& json) {
    Object out;
    std::vector<QString> known{QStringLiteral("object"), QStringLiteral("roughness_seed")};
    for (const Key& key : kKeys) {
        known.push_back(QLatin1String(key.name));
        if (json.has(known.back()))
            out.*key.member = json.number(known.back()) / key.perUnit;
    }
    if (json.has("object"))
        out.id = json.text("object");
    if (json.has("roughness_seed"))
        out.roughnessSeed = static_cast<std::uint64_t>(std::max(0, json.integer("roughness_seed")));
    refuseUnknownKeys(json, known, QStringLiteral("an attribute of an object"));
    return out;
}

void checkObject(const Object& object, const QString& path, Problems& problems) { if (chiron_mutants::on(17)) {
    if ((object.recoveryShare > 0.0) != (object.recoveryTime_s > 0.0))
        problems.push_back({memberPath(path, "recovery_share"), QString::number(object.recoveryShare),
                            QStringLiteral("above 0 together with recovery_s, or both 0")});
    // rms slope of plane waves of one wavelength in all directions, along one of them: 2π rms/(√3 λ)
    const double slope =
        2.0 * core::kPi / std::sqrt(3.0) * object.roughness_m / object.roughnessWavelength_m;
    if (slope > kSteepest)
        problems.push_back({memberPath(path, "roughness_um"), QString::number(object.roughness_m * kUm),
                            QStringLiteral("at most %1 µm at this wavelength: a slope of %2")
                                .arg(std::floor(object.roughness_m / kUm * kSteepest / slope))
                                .arg(kSteepest)});
} else {
    if ((object.recoveryShare > 0.0) != (object.recoveryTime_s > 0.0))
        problems.push_back({memberPath(path, "recovery_share"), QString::number(object.recoveryShare),
                            QStringLiteral("above 0 together with recovery_s, or both 0")});
    // rms slope of plane waves of one wavelength in all directions, along one of them: 2π rms/(√3 λ)
    const double slope =
        2.0 * core::kPi / std::sqrt(3.0) * object.roughness_m / object.roughnessWavelength_m;
    if (slope > kSteepest)
        problems.push_back({memberPath(path, "roughness_um"), QString::number(object.roughness_m * kUm),
                            QStringLiteral("at most %1 µm at this wavelength: a slope of %2")
                                .arg(std::floor(object.roughness_m * kUm * kSteepest / slope))
                                .arg(kSteepest)});
} }

} // namespace chiron::catalogue
