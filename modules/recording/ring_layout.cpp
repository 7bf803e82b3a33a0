// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/ring_layout.h"

#include "recording/crc32c.h"

#include <cstring>
#include <fstream>

namespace chiron::recording {

std::uint32_t identityChecksum(const RingHeader& header) noexcept {
    std::array<std::uint8_t, offsetof(RingHeader, committed)> identity{};
    std::memcpy(identity.data(), &header, identity.size());
    std::memset(identity.data() + offsetof(RingHeader, checksum), 0, sizeof(header.checksum));
    return crc32c(identity);
}

std::string ringFilePrefix(const DatabaseId& database) {
    static constexpr const char* kDigits = "0123456789abcdef";
    std::string name = "chiron-";
    for (const std::uint8_t byte : database) {
        name += kDigits[byte >> 4];
        name += kDigits[byte & 15];
    }
    return name + "-";
}

std::string bootId() {
    std::ifstream file("/proc/sys/kernel/random/boot_id");
    std::string id;
    std::getline(file, id);
    return id;
}

} // namespace chiron::recording
